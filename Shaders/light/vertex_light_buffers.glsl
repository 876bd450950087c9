// The light at the vertices; bound by GL/MarchPass.
#include "light/vertex_light_layout.glsl"
uniform sampler2D vertexLightTexture;
vec4 fetchVertexLight(uint vertex) { return texelFetch(vertexLightTexture, texelOfVertex(vertex), 0); }
