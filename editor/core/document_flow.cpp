#include "editor/core/document_flow.hpp"

#include <system_error>
#include <utility>

#include "editor/core/kept_files.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

/// A name such as "gusts v1.2" has no extension, whatever follows its point.
fs::path withExtension(fs::path path) {
  if (path.extension() == ".json") return path;
  path += path.extension() == ".wind" ? ".json" : ".wind.json";
  return path;
}

/// It has no file, or one that it isn't to be saved to.
bool needsPath(const Document& document) {
  return document.path().empty() || !whyKept(document.path()).empty();
}

}  // namespace

void DocumentFlow::requestNew(Project start) {
  m_start = std::move(start);
  begin(Then::New);
}

void DocumentFlow::requestOpen() {
  m_openPath.reset();
  begin(Then::Open);
}

void DocumentFlow::requestOpen(fs::path path) {
  m_openPath = std::move(path);
  begin(Then::Open);
}

void DocumentFlow::requestSave() {
  m_then = Then::Nothing;
  if (needsPath(m_document)) {
    m_prompt = Prompt::ChooseSavePath;
  } else {
    saveToOwnFile();
  }
}

void DocumentFlow::requestSaveAs() {
  m_then = Then::Nothing;
  m_prompt = Prompt::ChooseSavePath;
}

void DocumentFlow::requestQuit() {
  begin(Then::Quit);
}

void DocumentFlow::begin(Then then) {
  m_then = then;
  if (then == Then::Quit && workUnderWay && !workUnderWay().empty()) {
    m_prompt = Prompt::StopWork;
  } else {
    askToSave();
  }
}

void DocumentFlow::askToSave() {
  m_prompt = Prompt::None;
  if (m_document.dirty()) {
    m_prompt = Prompt::SaveChanges;
  } else {
    proceed();
  }
}

/// Nothing stands in the way any more.
void DocumentFlow::proceed() {
  m_prompt = Prompt::None;
  const Then then = std::exchange(m_then, Then::Nothing);
  if (then == Then::Quit) {
    m_quit = true;
  } else if (then == Then::New) {
    m_document.startNew(std::exchange(m_start, Project{}));
    if (onReplaced) onReplaced();
    if (onDone) onDone("New project");
  } else if (then == Then::Open && !m_openPath) {
    m_then = Then::Open;
    m_prompt = Prompt::ChooseOpenPath;
  } else if (then == Then::Open) {
    const fs::path path = *std::exchange(m_openPath, std::nullopt);
    const Status status = m_document.open(path, outsideFor ? outsideFor(path) : OutsideFiles::Refuse);
    if (!status) {
      fail(status.error());
      return;
    }
    if (onReplaced) onReplaced();
    if (onFileUsed) onFileUsed(path);
    const std::string why = whyKept(path);
    if (onDone)
      onDone("Opened " + path.filename().string() + (why.empty() ? "" : ". Saving will ask for a place: " + why));
    if (m_document.outsideRefused()) {
      m_prompt = Prompt::OutsideFiles;
    } else if (!m_document.missing().empty()) {
      Error error{ErrorKind::BadInput, m_document.missing()};
      error.problems.push_back({{}, {}, "It is shown without them, and keeps their names."});
      fail(error);
    }
  }
}

void DocumentFlow::answerSaveChanges(SaveAnswer answer) {
  if (m_prompt != Prompt::SaveChanges) return;
  if (answer == SaveAnswer::Cancel) {
    cancel();
  } else if (answer == SaveAnswer::DontSave) {
    proceed();
  } else if (needsPath(m_document)) {
    m_prompt = Prompt::ChooseSavePath;
  } else {
    saveToOwnFile();
  }
}

void DocumentFlow::answerPath(fs::path path) {
  if (path.empty()) {
    cancel();
  } else if (m_prompt == Prompt::ChooseOpenPath) {
    m_openPath = std::move(path);
    proceed();
  } else if (m_prompt == Prompt::ChooseSavePath) {
    path = withExtension(std::move(path));
    if (const std::string why = whyKept(path); !why.empty()) {
      fail(makeError(ErrorKind::BadInput, path.string(), {}, "can't be saved there: " + why));
      return;  // the question stays
    }
    std::error_code ignored;
    const bool other = path != m_document.path();
    m_path = std::move(path);
    if (other && fs::exists(m_path, ignored)) {
      m_prompt = Prompt::ConfirmOverwrite;
    } else if (other) {
      saveTo(m_path);
    } else {
      saveToOwnFile();
    }
  }
}

void DocumentFlow::answerOverwrite(bool overwrite) {
  if (m_prompt != Prompt::ConfirmOverwrite) return;
  if (overwrite) {
    saveTo(m_path);
  } else {
    m_prompt = Prompt::ChooseSavePath;
  }
}

void DocumentFlow::answerChanged(ChangedAnswer answer) {
  if (m_prompt != Prompt::ConfirmChanged) return;
  if (answer == ChangedAnswer::Replace) {
    saveTo(m_document.path());
  } else if (answer == ChangedAnswer::AnotherName) {
    m_prompt = Prompt::ChooseSavePath;
  } else {
    cancel();
  }
}

void DocumentFlow::answerStopWork(bool stop) {
  if (m_prompt != Prompt::StopWork) return;
  if (stop) {
    askToSave();
  } else {
    cancel();
  }
}

void DocumentFlow::answerOutside(bool allow) {
  if (m_prompt != Prompt::OutsideFiles) return;
  cancel();
  if (!allow) return;
  const fs::path path = m_document.path();
  if (onAllowOutside) onAllowOutside(path);
  requestOpen(path);
}

void DocumentFlow::cancel() {
  m_prompt = Prompt::None;
  m_then = Then::Nothing;
  m_openPath.reset();
  m_start = Project{};
}

/// Over a file that is no longer the one that was read only when that was asked for.
void DocumentFlow::saveToOwnFile() {
  if (m_document.changedOnDisk()) {
    m_prompt = Prompt::ConfirmChanged;
  } else {
    saveTo(m_document.path());
  }
}

void DocumentFlow::saveTo(const fs::path& target) {
  // A copy: the path may be the document's own.
  const fs::path path = target;
  m_prompt = Prompt::None;
  const Status status = m_document.saveAs(path);
  if (!status) {
    // Whatever should have followed would lose the work.
    cancel();
    fail(status.error());
    return;
  }
  if (onFileUsed) onFileUsed(path);
  if (onDone) onDone("Saved " + path.filename().string());
  proceed();
}

void DocumentFlow::fail(const Error& error) {
  if (onFailure) onFailure(error);
}

}  // namespace windloom::editor
