#include "engine/gpu/shader_library.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/gpu/object_label.hpp"
#include "engine/gpu/shader_source.hpp"

namespace windloom::gpu {
namespace fs = std::filesystem;

struct ShaderLibrary::Entry {
  std::string name;
  std::vector<std::string> stages;
  std::string defines;
  Program program;
  struct File {
    fs::path path;
    fs::file_time_type time;
  };
  std::vector<File> files;
};

namespace {

fs::file_time_type timeOf(const fs::path& path) {
  std::error_code ec;
  const fs::file_time_type time = fs::last_write_time(path, ec);
  return ec ? fs::file_time_type::min() : time;
}

GLenum stageOf(std::string_view file) {
  const std::string_view extension = file.substr(std::min(file.rfind('.'), file.size()));
  if (extension == ".vert") return GL_VERTEX_SHADER;
  if (extension == ".frag") return GL_FRAGMENT_SHADER;
  if (extension == ".geom") return GL_GEOMETRY_SHADER;
  WL_REQUIRE(extension == ".comp", "a shader file is .vert, .frag, .geom or .comp");
  return GL_COMPUTE_SHADER;
}

std::string logOf(GLuint name, decltype(glGetShaderiv) getValue, decltype(glGetShaderInfoLog) getLog) {
  GLint length = 0;
  getValue(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  getLog(name, static_cast<GLsizei>(log.size()), nullptr, log.data());
  while (!log.empty() && log.back() == '\0') log.pop_back();
  return log;
}

Result<Handle<ShaderKind>> compile(const ShaderSource& source, GLenum stage, const std::string& label) {
  Handle<ShaderKind> shader(glCreateShader(stage));
  labelObject(ShaderKind::kLabel, shader.name(), label);
  const char* text = source.text.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  return Error{ErrorKind::Machine, problemsOfLog(logOf(shader.name(), glGetShaderiv, glGetShaderInfoLog), source)};
}

/// What the driver is given, for other compilers to read: FOLDER/HASH/STAGE.EXTENSION with the program's name and the
/// files that it is made of in comments at the end, where they change no line.
void dump(const fs::path& folder, const std::string& program, const std::string& stage, const ShaderSource& source) {
  std::string text = source.text + "// program: " + program + "\n// stage: " + stage + "\n";
  for (const std::string& file : source.files) text += "// file: " + file + "\n";
  const std::string name = std::to_string(std::hash<std::string>{}(text)) + fs::path(stage).extension().string();
  if (const Status written = writeFileAtomically(folder / name, text); !written) logError(written.error().text());
}

}  // namespace

Result<std::unique_ptr<ShaderLibrary>> ShaderLibrary::create() {
  Result<fs::path> folder = findDataFolder("shaders");
  if (!folder) return folder.error();
  return std::make_unique<ShaderLibrary>(std::move(*folder));
}

ShaderLibrary::ShaderLibrary(fs::path folder) : m_folder(std::move(folder)) {}
ShaderLibrary::~ShaderLibrary() = default;

Result<Handle<ProgramKind>> ShaderLibrary::build(Entry& entry) const {
  entry.files.clear();
  Handle<ProgramKind> program(glCreateProgram());
  labelObject(ProgramKind::kLabel, program.name(), entry.name);
  std::vector<Handle<ShaderKind>> shaders;
  Error failure{ErrorKind::Machine, {}};
  for (const std::string& stage : entry.stages) {
    std::vector<fs::path> touched;
    const Result<ShaderSource> source = readShaderSource(m_folder, stage, entry.defines, touched);
    for (const fs::path& path : touched) entry.files.push_back({path, timeOf(path)});
    if (!source) {
      failure.problems.insert(failure.problems.end(), source.error().problems.begin(), source.error().problems.end());
      continue;
    }
    if (const char* folder = std::getenv("WINDLOOM_SHADER_DUMP")) dump(folder, entry.name, stage, *source);
    Result<Handle<ShaderKind>> shader = compile(*source, stageOf(stage), entry.name + " " + stage);
    if (!shader) {
      failure.problems.insert(failure.problems.end(), shader.error().problems.begin(), shader.error().problems.end());
      continue;
    }
    glAttachShader(program.name(), shader->name());
    shaders.push_back(std::move(*shader));
  }
  if (!failure.problems.empty()) return failure;
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  std::string log = logOf(program.name(), glGetProgramiv, glGetProgramInfoLog);
  std::ranges::replace(log, '\n', ' ');
  return makeError(ErrorKind::Machine, "shaders/" + entry.stages.front(), {},
                   "'" + entry.name + "' does not link: " + log);
}

Result<Program*> ShaderLibrary::load(const ProgramSpec& spec, std::string_view moreDefines) {
  auto entry = std::make_unique<Entry>();
  entry->name = spec.name;
  entry->defines = std::string(spec.defines) + (moreDefines.empty() ? "" : " ") + std::string(moreDefines);
  std::string key = entry->defines;
  for (const std::string_view stage : spec.stages) {
    if (stage.empty()) continue;
    entry->stages.emplace_back(stage);
    key.append("|").append(stage);
  }
  WL_REQUIRE(!entry->stages.empty(), "a program has a stage");
  if (const auto known = m_entries.find(key); known != m_entries.end()) return &known->second->program;
  Result<Handle<ProgramKind>> built = build(*entry);
  if (!built) return built.error();
  entry->program = Program(std::move(*built));
  Program* program = &entry->program;
  m_entries.emplace(std::move(key), std::move(entry));
  return program;
}

Status ShaderLibrary::loadAll(std::span<const ProgramSpec> specs) {
  Error failure{ErrorKind::Machine, {}};
  for (const ProgramSpec& spec : specs) {
    const Result<Program*> program = load(spec);
    if (program) continue;
    for (Problem problem : program.error().problems) {
      problem.message += " [" + std::string(spec.name) + "]";
      failure.problems.push_back(std::move(problem));
    }
  }
  if (!failure.problems.empty()) return failure;
  return Done{};
}

ShaderLibrary::Reload ShaderLibrary::reloadChanged() {
  Reload result;
  for (const auto& [key, entry] : m_entries) {
    const auto changed = [](const Entry::File& file) { return timeOf(file.path) != file.time; };
    if (std::none_of(entry->files.begin(), entry->files.end(), changed)) continue;
    Result<Handle<ProgramKind>> built = build(*entry);
    if (built) {
      entry->program = Program(std::move(*built));
      ++result.replaced;
    } else {
      result.problems.insert(result.problems.end(), built.error().problems.begin(), built.error().problems.end());
    }
  }
  return result;
}

}  // namespace windloom::gpu
