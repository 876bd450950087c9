// Whether a line meets a box, by separating axes, without a division. Given are the box's middle from a point of the
// line, its half size, the line's direction and the magnitudes of that.
bool lineMeetsBox(vec3 m, vec3 h, vec3 d, vec3 size)
{
  return abs(d.y * m.z - d.z * m.y) <= h.y * size.z + h.z * size.y &&
    abs(d.z * m.x - d.x * m.z) <= h.z * size.x + h.x * size.z &&
    abs(d.x * m.y - d.y * m.x) <= h.x * size.y + h.y * size.x;
}
