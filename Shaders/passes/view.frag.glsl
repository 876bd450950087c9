// A measure of each pixel, in the colours of a table.
//VTK::Output::Dec

uniform vec4 viewport; // x, y, width, height in pixels
uniform sampler2D measureTexture; // of each pixel: tetrahedra crossed, lookups, error bound, 1 if it has no bound
uniform sampler2D colorTexture; // one row
uniform int measure; // the shown channel
uniform bool logarithmic;
uniform vec2 measureRange; // of the measure, or of its decimal logarithm

const vec4 NoBound = vec4(0.5, 0.5, 0.5, 1.0); // of interpolated pixels

void main()
{
  vec4 measures = texelFetch(measureTexture, ivec2(gl_FragCoord.xy - viewport.xy), 0);
  bool hasBound = !(measures.w > 0.0);
  if (hasBound && !(measures.x > 0.0))
  {
    discard; // the ray crossed nothing
  }
  float value = measures[measure];
  if (logarithmic)
  {
    value = log(max(value, 1e-37)) / log(10.0);
  }
  float position = clamp((value - measureRange.x) / (measureRange.y - measureRange.x), 0.0, 1.0);
  int size = textureSize(colorTexture, 0).x;
  int entry = min(int(position * float(size)), size - 1);
  vec4 color = vec4(texelFetch(colorTexture, ivec2(entry, 0), 0).rgb, 1.0);
  gl_FragData[0] = hasBound ? color : NoBound;
}
