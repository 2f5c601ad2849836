#pragma once
// Code points of Fork Awesome (fonts-fork-awesome), UTF-8. Where the font isn't installed `icon` gives the text
// in its place, so that no button is ever blank.

#include "editor/widgets/look.hpp"

namespace windloom::editor::icons {

inline constexpr const char* kSelect = "\xef\x89\x85";       // f245 mouse-pointer
inline constexpr const char* kMove = "\xef\x81\x87";         // f047 arrows
inline constexpr const char* kRotate = "\xef\x80\xa1";       // f021 refresh
inline constexpr const char* kScale = "\xef\x81\xa5";        // f065 expand
inline constexpr const char* kEraser = "\xef\x84\xad";       // f12d eraser
inline constexpr const char* kDraw = "\xef\x84\xa6";         // f126 code-fork
inline constexpr const char* kObstacle = "\xef\x84\x91";     // f111 circle
inline constexpr const char* kProbe = "\xef\x81\x9b";        // f05b crosshairs
inline constexpr const char* kPlay = "\xef\x81\x8b";         // f04b
inline constexpr const char* kPause = "\xef\x81\x8c";        // f04c
inline constexpr const char* kStep = "\xef\x81\x91";         // f051 step-forward
inline constexpr const char* kRestart = "\xef\x81\x89";      // f049 fast-backward
inline constexpr const char* kUndo = "\xef\x83\xa2";         // f0e2
inline constexpr const char* kRedo = "\xef\x80\x9e";         // f01e repeat
inline constexpr const char* kEye = "\xef\x81\xae";          // f06e
inline constexpr const char* kEyeOff = "\xef\x81\xb0";       // f070
inline constexpr const char* kSpeaker = "\xef\x80\xa8";      // f028 volume-up
inline constexpr const char* kSpeakerOff = "\xef\x80\xa6";   // f026 volume-off
inline constexpr const char* kLock = "\xef\x80\xa3";         // f023
inline constexpr const char* kUnlock = "\xef\x82\x9c";       // f09c
inline constexpr const char* kTree = "\xef\x86\xbb";         // f1bb
inline constexpr const char* kLeaf = "\xef\x81\xac";         // f06c
inline constexpr const char* kFile = "\xef\x80\x96";         // f016 file-o
inline constexpr const char* kFolder = "\xef\x81\xbb";       // f07b
inline constexpr const char* kFolderOpen = "\xef\x81\xbc";   // f07c
inline constexpr const char* kUp = "\xef\x85\x88";           // f148 level-up
inline constexpr const char* kHome = "\xef\x80\x95";         // f015
inline constexpr const char* kSave = "\xef\x83\x87";         // f0c7 floppy-o
inline constexpr const char* kArrow = "\xef\x85\xb8";        // f178 long-arrow-right
inline constexpr const char* kVectors = "\xef\x80\x8a";      // f00a th
inline constexpr const char* kSpeed = "\xef\x83\xa4";        // f0e4 tachometer
inline constexpr const char* kStreamlines = "\xef\x81\xa4";  // f064 share
inline constexpr const char* kDivergence = "\xef\x82\xb2";   // f0b2 arrows-alt
inline constexpr const char* kVorticity = "\xef\x87\x8e";    // f1ce circle-o-notch
inline constexpr const char* kLic = "\xef\x80\xb9";          // f039 align-justify
inline constexpr const char* kWarning = "\xef\x81\xb1";      // f071 exclamation-triangle
inline constexpr const char* kInfo = "\xef\x81\x9a";         // f05a info-circle
inline constexpr const char* kError = "\xef\x81\x97";        // f057 times-circle
inline constexpr const char* kPoint = "\xef\x86\x92";        // f192 dot-circle-o
inline constexpr const char* kLoop = "\xef\x81\xb9";         // f079 retweet
inline constexpr const char* kBox = "\xef\x83\x88";          // f0c8 square
inline constexpr const char* kPolygon = "\xef\x88\x99";      // f219 diamond
inline constexpr const char* kVortex = "\xef\x87\x8e";       // f1ce circle-o-notch
inline constexpr const char* kBall = "\xef\x87\xa3";         // f1e3 futbol-o
inline constexpr const char* kCapsule = "\xef\x88\x84";      // f204 toggle-off
inline constexpr const char* kMesh = "\xef\x86\xb2";         // f1b2 cube
inline constexpr const char* kPlant = "\xef\x86\x8c";        // f18c pagelines
inline constexpr const char* kSurface = "\xef\x82\xac";      // f0ac globe
inline constexpr const char* kRotor = "\xef\x81\xa9";        // f069 asterisk
inline constexpr const char* kBrush = "\xef\x87\xbc";        // f1fc paint-brush

/// `symbol`, or `text` where the icon font is missing.
inline const char* icon(const char* symbol, const char* text) {
  return look().hasIcons ? symbol : text;
}

}  // namespace windloom::editor::icons
