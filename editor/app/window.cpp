#include "editor/app/window.hpp"

// epoxy first: it must be the one that names OpenGL's functions.
#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>

#include "engine/core/file.hpp"
#include "engine/gpu/context.hpp"
#include "engine/io/image.hpp"

namespace windloom::editor {

namespace {

constexpr const char* kNeeded = "Windloom's editor needs OpenGL 4.5 and a display.";

constexpr double kMessageSeconds = 15;

std::string lastGlfwError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

GLFWwindow* openWindow(const WindowOptions& options, int major, int minor) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
  if (major * 10 + minor >= 32) glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, gpu::strictAsked() ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);  // where the driver can tell
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  // What the desktop entry calls itself, so that its icon stands for the window.
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "windloom-editor");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "windloom-editor");
  glfwWindowHint(GLFW_MAXIMIZED, options.maximised ? GLFW_TRUE : GLFW_FALSE);
  return glfwCreateWindow(options.width, options.height, "Windloom", nullptr, nullptr);
}

/// Draws the message in a window of any OpenGL from 3.0 on until it is closed.
void runMessageWindow(GLFWwindow* window, const std::string& message) {
  Look look;
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().UserData = &look;
  applyTheme(look);
  loadFonts(look);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  if (ImGui_ImplOpenGL3_Init("#version 130")) {
    // Also ends by itself: the message is on standard error as well, and a script must not wait for ever.
    const double end = glfwGetTime() + kMessageSeconds;
    while (!glfwWindowShouldClose(window) && glfwGetTime() < end) {
      glfwWaitEventsTimeout(0.1);
      ImGui_ImplOpenGL3_NewFrame();
      ImGui_ImplGlfw_NewFrame();
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
      ImGui::Begin("message", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
      ImGui::TextWrapped("%s", message.c_str());
      if (ImGui::Button("Close")) glfwSetWindowShouldClose(window, GLFW_TRUE);
      ImGui::End();
      ImGui::Render();
      ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
      glfwSwapBuffers(window);
    }
    ImGui_ImplOpenGL3_Shutdown();
  }
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

/// Why there is no OpenGL 4.5 here, with what there is instead.
Error describeOldOpenGl(const std::string& reason) {
  GLFWwindow* window = openWindow({.width = 640, .height = 220}, 1, 0);
  std::string found = "no OpenGL at all";
  if (window) {
    glfwMakeContextCurrent(window);
    const auto text = [](GLenum name) {
      const auto* bytes = glGetString(name);
      return std::string(bytes ? reinterpret_cast<const char*>(bytes) : "?");
    };
    found = "OpenGL " + text(GL_VERSION) + " on " + text(GL_RENDERER);
  }
  std::string message = std::string(kNeeded) + " Found: " + found + " (" + reason +
                        "). A newer graphics driver may help; the command line (windloom validate, sample, bake) works "
                        "without OpenGL.";
  if (window) glfwDestroyWindow(window);
  return makeError(ErrorKind::Machine, std::move(message));
}

/// Of the sizes that title bars, docks and switchers take. Without the files the system shows its own.
void setIcon(GLFWwindow* window) {
  const auto folder = findDataFolder("icons");
  if (!folder) return;
  std::vector<Image> images;
  for (const char* name : {"windloom-16.png", "windloom-32.png", "windloom-48.png", "windloom-128.png"}) {
    auto image = readPng(*folder / name);
    if (image && image->channels == 4) images.push_back(std::move(*image));
  }
  std::vector<GLFWimage> icons;
  for (Image& image : images) icons.push_back({image.width, image.height, image.pixels.data()});
  glfwSetWindowIcon(window, int(icons.size()), icons.data());
}

Window& ownerOf(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Result<std::unique_ptr<Window>> Window::create(const WindowOptions& options) {
  if (!glfwInit())
    return makeError(ErrorKind::Machine, std::string(kNeeded) + " No display could be opened: " + lastGlfwError() +
                                             ". The command line (windloom render, bake) works without one.");
  GLFWwindow* window = openWindow(options, 4, 5);
  if (!window) {
    Error error = describeOldOpenGl(lastGlfwError());
    glfwTerminate();
    return error;
  }
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  setIcon(window);
  return std::unique_ptr<Window>(new Window(window));
}

void showTrouble(const std::string& message) {
  if (!glfwInit()) return;
  if (GLFWwindow* window = openWindow({.width = 640, .height = 220}, 1, 0)) {
    glfwMakeContextCurrent(window);
    if (epoxy_gl_version() >= 30) runMessageWindow(window, message);
    glfwDestroyWindow(window);
  }
  glfwTerminate();
}

Window::Window(GLFWwindow* window) : m_window(window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the layout is kept with the preferences
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigInputTextCursorBlink = true;
  ImGui_ImplGlfw_InitForOpenGL(window, false);
  ImGui_ImplOpenGL3_Init("#version 450 core");
  installCallbacks();
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(m_window);
  glfwTerminate();
}

void InputFeeder::before(GLFWwindow* window, const std::vector<InputEvent>& events) {
  for (const InputEvent& event : events) switch (event.kind) {
      case InputEvent::Kind::MouseMove:
        m_x = event.x;
        m_y = event.y;
        break;
      case InputEvent::Kind::MouseButton:
        if (event.code < int(m_down.size())) m_down[std::size_t(event.code)] = event.action != GLFW_RELEASE;
        break;
      case InputEvent::Kind::Wheel:
        ImGui_ImplGlfw_ScrollCallback(window, event.x, event.y);
        break;
      case InputEvent::Kind::Key:
        ImGui_ImplGlfw_KeyCallback(window, event.code, event.scancode, event.action, event.modifiers);
        break;
      case InputEvent::Kind::Text:
        ImGui_ImplGlfw_CharCallback(window, unsigned(event.code));
        break;
      case InputEvent::Kind::Focus:
        ImGui_ImplGlfw_WindowFocusCallback(window, event.action);
        break;
    }
}

void InputFeeder::after() const {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(float(m_x), float(m_y));
  for (std::size_t i = 0; i < m_down.size(); ++i) io.MouseDown[i] = m_down[i];
}

void Window::installCallbacks() {
  using Kind = InputEvent::Kind;
  glfwSetWindowUserPointer(m_window, this);
  glfwSetCursorPosCallback(m_window, [](GLFWwindow* window, double x, double y) {
    ownerOf(window).m_queue.push({.kind = Kind::MouseMove, .x = x, .y = y});
  });
  glfwSetMouseButtonCallback(m_window, [](GLFWwindow* window, int button, int action, int modifiers) {
    ownerOf(window).m_queue.push({.kind = Kind::MouseButton, .code = button, .action = action, .modifiers = modifiers});
  });
  glfwSetScrollCallback(m_window, [](GLFWwindow* window, double x, double y) {
    ownerOf(window).m_queue.push({.kind = Kind::Wheel, .x = x, .y = y});
  });
  glfwSetKeyCallback(m_window, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    if (key == GLFW_KEY_UNKNOWN) return;
    ownerOf(window).m_queue.push(
        {.kind = Kind::Key, .code = key, .scancode = scancode, .action = action, .modifiers = modifiers});
  });
  glfwSetCharCallback(m_window, [](GLFWwindow* window, unsigned codePoint) {
    ownerOf(window).m_queue.push({.kind = Kind::Text, .code = int(codePoint)});
  });
  glfwSetWindowFocusCallback(m_window, [](GLFWwindow* window, int focused) {
    ownerOf(window).m_queue.push({.kind = Kind::Focus, .action = focused});
  });
  glfwSetDropCallback(m_window, [](GLFWwindow* window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) ownerOf(window).m_drops.emplace_back(paths[i]);
  });
}

void Window::beginFrame(double waitSeconds, bool holdKeys) {
  if (waitSeconds > 0 && m_queue.empty())
    glfwWaitEventsTimeout(waitSeconds);
  else
    glfwPollEvents();
  m_events = m_queue.takeFrame(holdKeys, ImGui::GetIO().WantTextInput);
  m_feeder.before(m_window, m_events);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  m_feeder.after();
  ImGui::NewFrame();
}

void Window::endFrame() {
  ImGui::Render();
}

void Window::clear(glm::vec3 colour) {
  const GLfloat value[] = {colour.x, colour.y, colour.z, 1.0f};
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, value);
}

void Window::paint() {
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::swap() {
  glfwSwapBuffers(m_window);
}

void Window::remakeFonts() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Window::setTitle(const std::string& title) {
  glfwSetWindowTitle(m_window, title.c_str());
}

void Window::requestClose() {
  glfwSetWindowShouldClose(m_window, GLFW_TRUE);
}

bool Window::closeRequested() const {
  return glfwWindowShouldClose(m_window) != 0;
}

void Window::keepOpen() {
  glfwSetWindowShouldClose(m_window, GLFW_FALSE);
}

glm::ivec2 Window::framebufferSize() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(m_window, &size.x, &size.y);
  return size;
}

glm::ivec2 Window::size() const {
  glm::ivec2 size{0};
  glfwGetWindowSize(m_window, &size.x, &size.y);
  return size;
}

bool Window::minimised() const {
  return glfwGetWindowAttrib(m_window, GLFW_ICONIFIED) != 0;
}

bool Window::maximised() const {
  return glfwGetWindowAttrib(m_window, GLFW_MAXIMIZED) != 0;
}

float Window::pixelRatio() const {
  const int width = size().x;
  return width > 0 ? float(framebufferSize().x) / float(width) : 1.0f;
}

float Window::contentScale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(m_window, &x, &y);
  // Where window pixels are already scaled (Wayland, macOS) the rest is what is left to do.
  return std::max(x, y) / pixelRatio();
}

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(m_window);
  return text ? text : "";
}

void Window::setClipboard(const std::string& text) {
  glfwSetClipboardString(m_window, text.c_str());
}

}  // namespace windloom::editor
