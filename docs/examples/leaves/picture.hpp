#pragma once
// The picture that is drawn into: several samples a pixel, which are joined when it is shown.

#include "gl_objects.hpp"

namespace game {

class Picture {
 public:
  /// Makes it the target of drawing. Its memory is made anew only where size or samples changed.
  void begin(int width, int height, int samples);
  /// Copies it into the window's framebuffer, which is the target then.
  void show();

 private:
  void copy(GLuint from, GLuint to) const;

  Framebuffer m_target, m_joined;
  Renderbuffer m_colour, m_depth, m_joinedColour;
  int m_width = 0, m_height = 0, m_samples = 0;
};

}  // namespace game
