#pragma once
// Expected failures travel as values: Result<T> holds a T or an Error. Broken promises are a matter
// for contract.hpp; no exception crosses a module border.

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/contract.hpp"

namespace windloom {

/// Whose fault an error is; decides the exit status of the command line.
enum class ErrorKind {
  BadInput,  ///< a file or value the user gave is wrong (exit 1)
  Usage,     ///< the command was called wrongly (exit 2)
  Machine,   ///< this machine can't: no OpenGL 4.5, disk full, no permission (exit 3)
};

/// One thing that is wrong, with its place.
struct Problem {
  std::string file;     ///< path as the user gave it; empty where there is no file
  std::string pointer;  ///< place in it: JSON pointer ("/graph/arrows/2/to"), or "line 12"; may be empty
  std::string message;  ///< what was found and what was expected, one sentence

  /// "file: /pointer: message", leaving out empty parts; one line without control characters (engine/core/text.hpp).
  [[nodiscard]] std::string text() const;
};

struct Error {
  ErrorKind kind = ErrorKind::BadInput;
  std::vector<Problem> problems;  ///< never empty

  /// All problems, one a line.
  [[nodiscard]] std::string text() const;
};

[[nodiscard]] Error makeError(ErrorKind kind, std::string message);
[[nodiscard]] Error makeError(ErrorKind kind, std::string file, std::string pointer, std::string message);

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return m_state.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value; calling it on a failure is a broken promise.
  T& value() & { return *required(std::get_if<0>(&m_state)); }
  const T& value() const& { return *required(std::get_if<0>(&m_state)); }
  T&& value() && { return std::move(*required(std::get_if<0>(&m_state))); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  [[nodiscard]] const Error& error() const { return *required(std::get_if<1>(&m_state)); }

 private:
  template <class U>
  static U* required(U* held) {
    WL_REQUIRE(held != nullptr, "value() of a failure, or error() of a success");
    return held;
  }
  std::variant<T, Error> m_state;
};

/// A result without a value.
struct Done {};
using Status = Result<Done>;

}  // namespace windloom
