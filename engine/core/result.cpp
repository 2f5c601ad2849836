#include "engine/core/result.hpp"

#include <cstdio>
#include <cstdlib>

#include "engine/core/text.hpp"

namespace windloom {

std::string Problem::text() const {
  std::string line;
  for (const std::string* part : {&file, &pointer}) {
    if (!part->empty()) line += printable(*part) + ": ";
  }
  return line + printable(message);
}

std::string Error::text() const {
  std::string all;
  for (const Problem& problem : problems) {
    if (!all.empty()) all += '\n';
    all += problem.text();
  }
  return all;
}

Error makeError(ErrorKind kind, std::string message) {
  return makeError(kind, {}, {}, std::move(message));
}

Error makeError(ErrorKind kind, std::string file, std::string pointer, std::string message) {
  return Error{kind, {Problem{std::move(file), std::move(pointer), std::move(message)}}};
}

void contractBroken(const char* condition, const char* message, const char* file, int line) {
  std::fprintf(stderr, "windloom: contract broken: %s (%s) at %s:%d\n", message, condition, file, line);
  std::abort();
}

}  // namespace windloom
