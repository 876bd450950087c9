// The light at the vertices of a mesh, or at the nodes of a lattice: one pixel each.
#include "language.glsl"
#include "passes/helper.glsl"

//VTK::Output::Dec

#include "passes/light_texel.glsl"

void main()
{
  vec4 light;
  if (IS_HELPER || !findLight(uvec2(gl_FragCoord.xy), light))
  {
    discard;
  }
  gl_FragData[0] = light;
}
