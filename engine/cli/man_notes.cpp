#include "engine/cli/man_notes.hpp"

namespace windloom::cli {
namespace {

constexpr ManEntry kExamples[] = {
    {"windloom new breeze.wind.json --template breeze", "Write a project to begin with."},
    {"windloom render breeze.wind.json --time 4 --out breeze.png", "See its grass after four seconds of wind."},
    {"windloom bake breeze.wind.json --out wind --format exr,windpack --preset godot --loop",
     "Take its wind into a game."},
    {"windloom edit breeze.wind.json", "Draw more wind."},
};
constexpr ManEntry kBakeExamples[] = {
    {"windloom bake meadow.wind.json --out wind --format npy", "Two seconds from the start, 30 frames a second."},
    {"windloom bake meadow.wind.json --out wind --preset unreal --format exr,atlas --from 2 --seconds 6 --fps 15 "
     "--resolution 256x256 --loop",
     "Six seconds that repeat without a jump, smaller, in the axes of an engine."},
};
constexpr ManEntry kRenderExamples[] = {
    {"windloom render meadow.wind.json --out meadow.png --time 6 --overlay arrows",
     "One picture with the drawn arrows."},
    {"windloom render meadow.wind.json --out film.png --frames 90 --fps 30 --size 1920x1080",
     "Three seconds as film.0000.png to film.0089.png."},
};
constexpr ManEntry kStatus[] = {
    {"0", "Done."},
    {"1", "The input is wrong; the message names the file, the place in it and what was expected."},
    {"2", "Wrong usage."},
    {"3", "This machine can't: no OpenGL 4.5, a full disk, no right to write."},
};
constexpr ManEntry kInterrupted[] = {
    {"130", "Ended by Ctrl+C; no unfinished file stays."},
};
constexpr ManEntry kEnvironment[] = {
    {"WINDLOOM_DATA",
     "Folder with shaders, projects and icons in place of ../share/windloom seen from the program's own folder."},
    {"WINDLOOM_THREADS", "Threads of the CPU backend, 1 to 256; all processors where it is not set."},
    {"WINDLOOM_EGL_DEVICE",
     "Number of the EGL device that pictures without a window are made with; the first that works "
     "where it is not set."},
    {"WINDLOOM_GL_DEBUG", "1: OpenGL's driver is asked for messages, and an error of it ends the program."},
    {"WINDLOOM_GL_POISON", "1: fresh textures hold values that show where one is read before it was written."},
    {"WINDLOOM_SHADER_DUMP", "Folder that the texts of all shaders are written to as the driver gets them."},
};
constexpr ManEntry kEditorEnvironment[] = {
    {"WINDLOOM_DATA",
     "Folder with shaders, projects and icons in place of ../share/windloom seen from the program's own folder."},
    {"WINDLOOM_THREADS", "Threads of the CPU backend, 1 to 256; all processors where it is not set."},
    {"XDG_CONFIG_HOME, XDG_STATE_HOME", "Where the folders named below lie, in place of ~/.config and ~/.local/state."},
};
constexpr ManEntry kFiles[] = {
    {"NAME.wind.json", "A project: JSON, described by project.schema.json in the documentation."},
    {"NAME.wind.json.bak", "The project as it was before it was last saved."},
    {"../share/windloom/projects",
     "The sample projects, seen from the program's folder. They stay as they are: bake and "
     "render read them there, the editor saves them elsewhere."},
};
constexpr ManEntry kEditorFiles[] = {
    {"~/.config/windloom/preferences.json", "Window, theme, recent files, shortcuts of your own."},
    {"~/.local/state/windloom/autosave", "Unsaved work of editors that run, or that ended without closing."},
};

constexpr ManSection kSections[] = {
    {"windloom", "EXAMPLES", kExamples},
    {"windloom-bake", "EXAMPLES", kBakeExamples},
    {"windloom-render", "EXAMPLES", kRenderExamples},
    {"windloom*", "EXIT STATUS", kStatus},
    {"windloom-bake", "", kInterrupted},
    {"windloom-sample", "", kInterrupted},
    {"windloom-render", "", kInterrupted},
    {"windloom", "ENVIRONMENT", kEnvironment},
    {"windloom-editor", "ENVIRONMENT", kEditorEnvironment},
    {"windloom*", "FILES", kFiles},
    {"windloom-editor", "", kEditorFiles},
};

}  // namespace

std::span<const ManSection> manSections() {
  return kSections;
}

}  // namespace windloom::cli
