// Samples of the light on a ray, and the part of the ray that waits for them.

#include "light/sphere_direction.glsl"
#include "light/incoming_light.glsl"

// The transmittance towards ambient light and each light from a point in the cell of the start.
vec4 sampleLight(Ray ray, LightStart start, real depth)
{
  start.point = ray.origin + ray.direction * depth;
  return incomingLight(start, 0u);
}

// Adds the stored part, with the given transmittance of the light.
void addPending(INOUT(Radiance) radiance, vec4 transmittance)
{
#if TETMARCH_SAMPLED_OCCLUSION
  radiance.color = radiance.color + radiance.pendingAmbient * transmittance.x;
  radiance.pendingAmbient = vec3(real(0), real(0), real(0));
#endif
#if TETMARCH_SAMPLED_SHADOWS
  radiance.color = radiance.color + radiance.pendingA * transmittance.y;
  radiance.pendingA = vec3(real(0), real(0), real(0));
#if TETMARCH_SEVERAL_SHADOWS
  radiance.color = radiance.color + radiance.pendingB * transmittance.z + radiance.pendingC * transmittance.w;
  radiance.pendingB = radiance.pendingA;
  radiance.pendingC = radiance.pendingA;
#endif
#endif
}
