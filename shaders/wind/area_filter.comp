#version 450 core
// The wind at another resolution, for recordings: each new cell is a weighted sum of old ones. The weights are those of
// Resampler (engine/session/resample.hpp), row by column.
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D windTexture;
layout(std430, binding = 0) writeonly buffer Cells { vec2 cells[]; };
// For each new column, then for each new row: first old one, number of weights, place of the first weight.
layout(std430, binding = 1) readonly buffer Taps { int taps[]; };
layout(std430, binding = 2) readonly buffer Weights { float weights[]; };
uniform ivec2 size;  // new cells

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(cell, size))) return;
  ivec2 old = textureSize(windTexture, 0);
  int column = 3 * cell.x, row = 3 * (size.x + cell.y);
  vec2 sum = vec2(0.0);
  int k = taps[row];
  for (int m = 0; m < taps[row + 1]; ++m) {
    vec2 along = vec2(0.0);
    int i = taps[column];
    for (int n = 0; n < taps[column + 1]; ++n) {
      along += texelFetch(windTexture, ivec2(i, k), 0).xy * weights[taps[column + 2] + n];
      i = i + 1 < old.x ? i + 1 : 0;
    }
    sum += along * weights[taps[row + 2] + m];
    k = k + 1 < old.y ? k + 1 : 0;
  }
  cells[cell.y * size.x + cell.x] = sum;
}
