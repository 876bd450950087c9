// The cells of 2 x 2 pixels between samples in which the picture may have an edge that no ray touches: the outline of
// the volume, or a jump in the depths of opaque geometry. Depths of a plane are linear.
//VTK::Output::Dec

#include "passes/sample_grid.glsl"

const float STEP_OF_DEPTH = 1.0 / 512.0; // in window depths, 0..1

uniform sampler2D outlineTexture; // Entries/Outlines.h
uniform sampler2D opaqueDepthTexture;
uniform vec2 depthsPerPixel;

float depthAt(ivec2 at)
{
  vec2 pixel = vec2(firstPixel + min(at, lastPixel)) + 0.5;
  return texelFetch(opaqueDepthTexture, ivec2(pixel * depthsPerPixel), 0).x;
}

float bendOf(ivec2 at, ivec2 axis)
{
  return abs(depthAt(at) - 2.0 * depthAt(at + axis) + depthAt(at + 2 * axis));
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  float edge = texelFetch(outlineTexture, at, 0).x;
  for (int i = 0; i <= 2; ++i)
  {
    float bend = max(bendOf(2 * at + ivec2(0, i), ivec2(1, 0)), bendOf(2 * at + ivec2(i, 0), ivec2(0, 1)));
    edge = max(edge, step(STEP_OF_DEPTH, bend));
  }
  gl_FragData[0] = vec4(edge, 0.0, 0.0, 0.0);
}
