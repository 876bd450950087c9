// Which lights opaque surfaces keep off a point of a ray. The triangles of a surface are searched for in a hierarchy of
// boxes. No ray passes between two triangles that share an edge (Woop, Benthin and Wald, "Watertight Ray/Triangle
// Intersection", 2013).

CONSTANT real SURFACE_MARGIN = real(1e-4); // in volume radii: precision of the depths at which rays end
CONSTANT real BOX_SLACK = real(1e-6);      // of boxes, as a share of their distance: rounding

// A ray in the coordinates of a surface, in which its box is about as large as the unit ball.
struct SurfaceRay
{
  vec3 origin;
  vec3 direction;
  vec3 right; // right, up, direction: orthogonal, of any length
  vec3 up;
  real end;   // length, in the units of dot(direction, point)
};

SurfaceRay rayToSurface(int surface, vec3 point, vec3 direction, real distance)
{
  vec4 x = fetchOpaqueSurface(4 * surface);
  vec4 y = fetchOpaqueSurface(4 * surface + 1);
  vec4 z = fetchOpaqueSurface(4 * surface + 2);
  vec4 p = vec4(point.x, point.y, point.z, real(1));
  vec4 d = vec4(direction.x, direction.y, direction.z, real(0));
  SurfaceRay ray;
  ray.origin = vec3(dot(x, p), dot(y, p), dot(z, p));
  ray.direction = vec3(dot(x, d), dot(y, d), dot(z, d));
  vec3 size = abs(ray.direction);
  vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(real(1), real(0), real(0))
    : (size.y <= size.z ? vec3(real(0), real(1), real(0)) : vec3(real(0), real(0), real(1)));
  ray.right = cross(ray.direction, axis);
  ray.up = cross(ray.right, ray.direction);
  ray.end = distance * dot(ray.direction, ray.direction);
  return ray;
}

bool meetsBox(SurfaceRay ray, int texel)
{
  vec4 middle = fetchOpaqueSurface(texel);
  vec4 extent = fetchOpaqueSurface(texel + 1);
  vec3 m = vec3(middle.x, middle.y, middle.z) - ray.origin;
  real slack = BOX_SLACK * (abs(m.x) + abs(m.y) + abs(m.z));
  vec3 h = vec3(extent.x + slack, extent.y + slack, extent.z + slack);
  vec3 d = ray.direction;
  vec3 size = abs(d);
  return lineMeetsBox(m, h, d, size) && dot(m, d) + dot(h, size) >= real(0) &&
    dot(m, d) - dot(h, size) <= ray.end;
}

// A vertex gets the same bits in each of its triangles.
vec3 projectedCorner(SurfaceRay ray, int texel)
{
  vec4 vertex = fetchOpaqueSurface(texel);
  precise real x = vertex.x - ray.origin.x;
  precise real y = vertex.y - ray.origin.y;
  precise real z = vertex.z - ray.origin.z;
  precise real right = x * ray.right.x + y * ray.right.y + z * ray.right.z;
  precise real up = x * ray.up.x + y * ray.up.y + z * ray.up.z;
  return vec3(right, up, x * ray.direction.x + y * ray.direction.y + z * ray.direction.z);
}

// Exchanging the ends of an edge exactly changes the sign.
real sideOfEdge(vec3 p, vec3 q)
{
  precise real side = p.x * q.y - p.y * q.x;
  return side;
}

bool meetsTriangle(SurfaceRay ray, int texel)
{
  vec3 a = projectedCorner(ray, texel);
  vec3 b = projectedCorner(ray, texel + 1);
  vec3 c = projectedCorner(ray, texel + 2);
  real u = sideOfEdge(b, c);
  real v = sideOfEdge(c, a);
  real w = sideOfEdge(a, b);
  bool inside =
    (u >= real(0) && v >= real(0) && w >= real(0)) || (u <= real(0) && v <= real(0) && w <= real(0));
  real sum = u + v + w;
  real depth = (u * a.z + v * b.z + w * c.z) / sum;
  return inside && sum != real(0) && depth > real(0) && depth < ray.end;
}

// Whether a surface is in the way from a point in a direction (unit length).
bool isInTheWay(int surface, vec3 point, vec3 direction, real distance)
{
  SurfaceRay ray = rayToSurface(surface, point, direction, distance);
  vec4 tree = fetchOpaqueSurface(4 * surface + 3);
  int leaves = int(tree.x);
  int trianglesOfLeaf = int(tree.y);
  int nodes = int(tree.z) * 4096 + int(tree.w);
  int triangles = nodes + 4 * leaves;
  int node = 1;     // 0: no more
  int triangle = 0; // the next one of the leaf to be tested, up to end
  int end = 0;
  bool hit = false;
  while (node > 0 || triangle < end)
  {
#if TETMARCH_COUNTS_TURNS
    countTurns(1);
#endif
    if (triangle < end)
    {
      hit = meetsTriangle(ray, triangles + 3 * triangle);
      triangle = triangle + 1;
      node = hit ? 0 : node;
      end = hit ? triangle : end;
    }
    else
    {
      bool met = meetsBox(ray, nodes + 2 * node);
      bool leaf = node >= leaves;
      triangle = (node - leaves) * trianglesOfLeaf;
      end = met && leaf ? triangle + trianglesOfLeaf : triangle;
      // Past this node and those below it: to the right sibling of the nearest ancestor that is a left child, or to the
      // root if there is none.
      int next = node + 1;
      int following = next / (next & -next);
      node = met && !leaf ? 2 * node : (following > 1 ? following : 0);
    }
  }
  return hit;
}

// A bit for each light that a surface keeps off a point of the ray. A ray may end in a surface: the light is that before
// it.
uint lightsKeptOff(Ray ray, vec3 end)
{
  vec3 point = end - ray.direction * SURFACE_MARGIN;
  uint blocked = 0u;
  for (int k = 0; k < shadowSourceCount; ++k)
  {
    vec4 source = fetchShadowSource(k);
    vec3 toLight = vec3(source.x, source.y, source.z) - point * source.w;
    real far = sqrt(dot(toLight, toLight));
    vec3 direction = toLight * (real(1) / max(far, TINY));
    real distance = source.w > real(0) ? min(far, opaqueReach) : opaqueReach;
    bool lit = true;
    for (int surface = 0; surface < opaqueSurfaceCount && lit; ++surface)
    {
      lit = !isInTheWay(surface, point, direction, distance);
    }
    blocked = lit ? blocked : blocked | 1u << uint(k);
  }
  return blocked;
}
