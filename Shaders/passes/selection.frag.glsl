// The colour that a hardware selector reads in each pixel, at the depth of the picked point.
//VTK::Output::Dec

uniform vec2 corner; // of the selected area, in pixels
uniform sampler2D selectionTexture; // a colour, and a window depth, which is 1 or more where nothing was picked

void main()
{
  vec4 selection = texelFetch(selectionTexture, ivec2(gl_FragCoord.xy - corner), 0);
  if (selection.w >= 1.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(selection.rgb, 1.0);
  gl_FragDepth = selection.w;
}
