// Samples of the light on a ray, and the part of the ray that waits for them.

#include "light/sphere_direction.glsl"
#include "light/incoming_light.glsl"
#if TETMARCH_SAMPLED_SURFACES
#include "march/line_box.glsl"
#include "light/opaque_surfaces.glsl"
#endif

// The transmittance towards each light from a point in the cell of the start.
vec4 sampleLight(Ray ray, LightStart start, real depth)
{
  start.point = ray.origin + ray.direction * depth;
#if TETMARCH_SAMPLED_SURFACES
  return incomingLight(start, lightsKeptOff(ray, start.point));
#else
  return incomingLight(start, 0u);
#endif
}

// Adds the stored part, with the given transmittance of the light.
void addPending(INOUT(Radiance) radiance, vec4 transmittance)
{
#if TETMARCH_LIGHT_TOLERANCE
  radiance.pendingWeight = real(0);
  radiance.pendingMoment = real(0);
#endif
  vec3 none = vec3(real(0), real(0), real(0));
#if TETMARCH_SAMPLED_BEAMS
  radiance.color = radiance.color + radiance.pendingA * transmittance.y;
  radiance.pendingA = none;
#endif
#if TETMARCH_SEVERAL_SHADOWS
  radiance.color = radiance.color + radiance.pendingB * transmittance.z + radiance.pendingC * transmittance.w;
  radiance.pendingB = none;
  radiance.pendingC = none;
#endif
#if TETMARCH_SAMPLED_OCCLUSION
  radiance.color = radiance.color + radiance.pendingAmbient * transmittance.x;
  radiance.pendingAmbient = none;
#endif
}

#if TETMARCH_LIGHT_TOLERANCE
// The colour that waits for light, times the transmittance; its greatest channel.
real pendingTimes(vec4 transmittance, Radiance radiance)
{
  real waiting = real(0);
#if TETMARCH_SAMPLED_BEAMS
  waiting = greatest(radiance.pendingA) * abs(transmittance.y);
#endif
#if TETMARCH_SEVERAL_SHADOWS
  waiting = waiting + greatest(radiance.pendingB) * abs(transmittance.z) +
    greatest(radiance.pendingC) * abs(transmittance.w);
#endif
#if TETMARCH_SAMPLED_OCCLUSION
  waiting = waiting + greatest(radiance.pendingAmbient) * abs(transmittance.x);
#endif
  return waiting;
}

// Where what waits is on average, from where the transmittance was `begin`, 0, to here, 1.
real pendingPlace(real begin, Radiance radiance)
{
  real mean = radiance.pendingMoment / max(radiance.pendingWeight, TINY);
  return clamp((begin - mean) / max(begin - radiance.transmittance, TINY), real(0), real(1));
}
#endif
