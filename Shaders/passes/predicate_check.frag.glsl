// The check of the predicate on this GL (GL/PredicateCheck): each pixel is a case, computed outside and inside of a
// loop. The compiler may optimise each separately, but the march relies on equal bits.
#include "language.glsl"
#include "tet/edge_sign.glsl"
#include "march/ray.glsl"

//VTK::Output::Dec

uniform sampler2D caseTexture; // Variants/PredicateCases.h
uniform int turns;             // iterations of the loop: several, but not a constant, so that it is not unrolled

vec4 caseTexel(ivec2 at, int i) { return texelFetch(caseTexture, ivec2(6 * at.x + i, at.y), 0); }

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  Ray ray;
  ray.origin = caseTexel(at, 2).xyz;
  ray.right = caseTexel(at, 3).xyz;
  ray.up = caseTexel(at, 4).xyz;
  ray.direction = caseTexel(at, 5).xyz;

  vec4 edge = caseTexel(at, 0);
  float alone = edgeCross(edge.xy, edge.zw);
  vec3 pointAlone = project(ray, caseTexel(at, 1).xyz);

  float among = 0.0;
  vec3 pointAmong = vec3(0.0);
  bool left = false;
  bool leftBack = false;
  for (int turn = 0; turn < turns; ++turn)
  {
    ivec2 there = ivec2(at.x, (at.y + turns - 1 - turn) & 63); // the pixel itself is last
    vec4 next = caseTexel(there, 0);
    among = edgeCross(next.xy, next.zw);
    left = turnsLeft(among, next.xy, 1u, next.zw, 2u);
    leftBack = turnsLeft(edgeCross(next.zw, next.xy), next.zw, 2u, next.xy, 1u);
    pointAmong = project(ray, caseTexel(there, 1).xyz);
  }
  bool same = all(equal(pointAlone, pointAmong));
  gl_FragData[0] = vec4(alone, among, left ? 1.0 : 0.0, leftBack ? 1.0 : 0.0);
  gl_FragData[1] = vec4(pointAmong, same ? 1.0 : 0.0);
}
