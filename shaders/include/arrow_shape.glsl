// Where an arrow of the overlay runs. Needs frame.glsl, overlay.glsl.
struct ArrowLine {
  vec2 from, along, aside;
  float start, end;   // m along it: it begins and ends at the rims of its points' discs
  float halfWidth, head;  // m
};

ArrowLine arrowLine(OverlayMark mark) {
  ArrowLine line;
  vec2 span = mark.place.zw - mark.place.xy;
  float len = max(length(span), 1e-4);
  line.from = mark.place.xy;
  line.along = span / len;
  line.aside = vec2(-line.along.y, line.along.x);
  float least = metresFor(2.6 * pixelUnit(), mark.place.xy + 0.5 * span);
  line.halfWidth = max(arrowHalfWidth(mark.look.x), least) * (mark.look.w == MARK_NORMAL ? 1.0 : 1.25);
  line.start = min(0.8 * discRadius(mark.more.y, MARK_POINT, mark.place.xy), 0.25 * len);
  line.end = len - min(discRadius(mark.more.z, MARK_POINT, mark.place.zw), 0.25 * len);
  float room = line.end - line.start;
  line.halfWidth = min(line.halfWidth, 0.2 * room);
  line.head = min(3.4 * line.halfWidth, 0.6 * room);
  return line;
}
