#include "engine/gpu/shader_source.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <regex>

#include "engine/core/file.hpp"

namespace windloom::gpu {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kRoot = "shaders/";

std::string_view trimLeft(std::string_view line) {
  const std::size_t start = line.find_first_not_of(" \t");
  return start == std::string_view::npos ? std::string_view() : line.substr(start);
}

/// The quoted path of an include line; empty for `#include <...>`; nothing for any other line.
std::optional<std::string_view> includedPath(std::string_view line) {
  line = trimLeft(line);
  if (line.empty() || line.front() != '#') return std::nullopt;
  line = trimLeft(line.substr(1));
  if (line.substr(0, 7) != "include") return std::nullopt;
  line = trimLeft(line.substr(7));
  if (line.empty() || line.front() != '"') return std::string_view();
  const std::size_t end = line.find('"', 1);
  return end == std::string_view::npos ? std::string_view() : line.substr(1, end - 1);
}

class Assembler {
 public:
  Assembler(const fs::path& folder, std::string_view defines, std::vector<fs::path>& touched)
      : m_folder(folder), m_defines(defines), m_touched(touched) {}

  Status add(const std::string& file, const std::string& from) {
    const fs::path path = m_folder / file;
    m_touched.push_back(path);
    const Result<std::string> text = readFile(path);
    if (!text) {
      const std::string by = from.empty() ? "" : " (included by " + from + ")";
      return makeError(ErrorKind::Machine, std::string(kRoot) + file, {}, text.error().problems.front().message + by);
    }
    const std::size_t index = m_source.files.size();
    m_source.files.push_back(std::string(kRoot) + file);
    return addLines(*text, file, index);
  }

  ShaderSource take() { return std::move(m_source); }

 private:
  Status addLines(std::string_view text, const std::string& file, std::size_t index) {
    const bool entry = index == 0;
    if (entry && text.substr(0, 8) != "#version") {
      return makeError(ErrorKind::Machine, std::string(kRoot) + file, "line 1",
                       "a shader begins with '#version 450 core'");
    }
    for (int number = 1; !text.empty(); ++number) {
      const std::size_t end = text.find('\n');
      const std::string_view line = text.substr(0, end);
      text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
      if (const auto path = includedPath(line)) {
        if (Status added = include(std::string(*path), file, number); !added) return added;
        continue;
      }
      addLine(line, {index, number});
      if (entry && number == 1) addDefines();
    }
    return Done{};
  }

  Status include(const std::string& path, const std::string& file, int line) {
    if (path.empty()) return Done{};
    const bool fromRoot = path.rfind(kRoot, 0) == 0;
    const fs::path below = fromRoot ? fs::path(path.substr(kRoot.size())) : fs::path(file).parent_path() / path;
    const std::string name = below.lexically_normal().generic_string();
    if (std::find(m_source.files.begin(), m_source.files.end(), std::string(kRoot) + name) != m_source.files.end())
      return Done{};
    return add(name, std::string(kRoot) + file + ": line " + std::to_string(line));
  }

  void addDefines() {
    std::string_view rest = m_defines;
    while (!(rest = trimLeft(rest)).empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const std::string_view define = rest.substr(0, end);
      const std::size_t equals = define.find('=');
      const std::string name(define.substr(0, equals));
      addLine("#define " + name + " " + std::string(equals == std::string_view::npos ? "1" : define.substr(equals + 1)),
              {0, 1});
      rest = rest.substr(end);
    }
  }

  void addLine(std::string_view line, ShaderSource::Line origin) {
    m_source.text.append(line).push_back('\n');
    m_source.lines.push_back(origin);
  }

  const fs::path& m_folder;
  std::string_view m_defines;
  std::vector<fs::path>& m_touched;
  ShaderSource m_source;
};

}  // namespace

Result<ShaderSource> readShaderSource(const fs::path& folder, std::string_view file, std::string_view defines,
                                      std::vector<fs::path>& touched) {
  Assembler assembler(folder, defines, touched);
  if (Status added = assembler.add(std::string(file), {}); !added) return added.error();
  return assembler.take();
}

std::vector<Problem> problemsOfLog(std::string_view log, const ShaderSource& source) {
  const std::string& entry = source.files.front();
  static const std::regex kMesa(R"(^\d+:(\d+)\(\d+\):\s*(.*)$)");
  static const std::regex kNvidia(R"(^\d+\((\d+)\)\s*:\s*(.*)$)");
  static const std::regex kOther(R"(^(?:ERROR|WARNING):\s*\d+:(\d+):\s*(.*)$)");
  std::vector<Problem> problems;
  while (!log.empty()) {
    const std::size_t end = log.find('\n');
    std::string line(log.substr(0, end));
    log = end == std::string_view::npos ? std::string_view() : log.substr(end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == '\0' || line.back() == ' ')) line.pop_back();
    if (line.empty()) continue;
    std::smatch match;
    if (std::regex_match(line, match, kMesa) || std::regex_match(line, match, kNvidia) ||
        std::regex_match(line, match, kOther)) {
      const std::size_t at = static_cast<std::size_t>(std::strtoul(match[1].str().c_str(), nullptr, 10));
      if (at >= 1 && at <= source.lines.size()) {
        const ShaderSource::Line origin = source.lines[at - 1];
        problems.push_back({source.files[origin.file], "line " + std::to_string(origin.number), match[2].str()});
      } else {
        problems.push_back({entry, {}, match[2].str()});
      }
    } else if (!problems.empty()) {
      problems.back().message += " " + line;
    } else {
      problems.push_back({entry, {}, line});
    }
  }
  if (problems.empty()) problems.push_back({entry, {}, "does not compile, and the driver gives no message"});
  return problems;
}

}  // namespace windloom::gpu
