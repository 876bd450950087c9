// The depth of a picture drawn over the viewport: just before the far plane, where it is not transparent.
//VTK::Output::Dec

uniform vec4 viewport; // x, y, width, height in pixels
uniform sampler2D pictureTexture;

const float LAST_DEPTH = 1.0 - 1.0 / 16777216.0; // of 24 bits

void main()
{
  if (!(texture(pictureTexture, (gl_FragCoord.xy - viewport.xy) / viewport.zw).w > 0.0))
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
  gl_FragDepth = LAST_DEPTH;
}
