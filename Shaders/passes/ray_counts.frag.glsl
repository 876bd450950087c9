// A level of the pyramid of passes/ray_list.glsl: the running sums of the counts of 2 x 2 texels of the level below.
//VTK::Output::Dec

uniform sampler2D belowTexture;
uniform bool belowAreBits; // the level below is newRayTexture
uniform ivec2 belowSize;
uniform int belowColumn;   // its first one
uniform int column;        // the first one of this level

float countAt(ivec2 at)
{
  vec4 below = texelFetch(belowTexture, ivec2(min(at.x, belowSize.x - 1) + belowColumn, min(at.y, belowSize.y - 1)), 0);
  int bits = int(below.x * 7.0 + 0.5);
  float count = belowAreBits ? float((bits & 1) + (bits >> 1 & 1) + (bits >> 2)) : below.w;
  return at.x < belowSize.x && at.y < belowSize.y ? count : 0.0;
}

void main()
{
  ivec2 at = 2 * (ivec2(gl_FragCoord.xy) - ivec2(column, 0));
  vec4 counts = vec4(countAt(at), countAt(at + ivec2(1, 0)), countAt(at + ivec2(0, 1)), countAt(at + ivec2(1, 1)));
  counts.y += counts.x;
  counts.z += counts.y;
  gl_FragData[0] = vec4(counts.xyz, counts.z + counts.w);
}
