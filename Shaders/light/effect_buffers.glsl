// What the effects read. Lights are in the frame of the mesh, or in the world with the centre of the mesh as origin.
#if TETMARCH_VERTEX_GRADIENTS
uniform samplerBuffer gradientBuffer; // of the scalar at the vertices
vec3 fetchGradient(uint vertex) { return texelFetch(gradientBuffer, int(vertex)).xyz; }
#endif
#if TETMARCH_CELL_GRADIENTS
uniform samplerBuffer gradientBuffer; // of the scalar in the tetrahedra
vec3 fetchCellGradient(uint tet) { return texelFetch(gradientBuffer, int(tet)).xyz; }
#endif

#if TETMARCH_GRADIENT_OPACITY
uniform samplerBuffer gradientOpacityBuffer;
uniform int gradientOpacitySize;
uniform float gradientOpacityScale; // from the length of a gradient to a position in the table
float fetchGradientOpacity(int i) { return texelFetch(gradientOpacityBuffer, i).x; }
#endif

#if TETMARCH_SHADING
uniform bool twoSided;
uniform vec3 ambientColor;
uniform float specularPower;
uniform vec3 lightDiffuse[MOST_LIGHTS]; // times the property's diffuse
uniform vec3 lightSpecular[MOST_LIGHTS]; // times the property's specular

vec3 fetchLightDiffuse(int light) { return lightDiffuse[light]; }
vec3 fetchLightSpecular(int light) { return lightSpecular[light]; }

#if !TETMARCH_HEADLIGHT_ONLY
uniform vec4 lightPlace[MOST_LIGHTS];
vec4 fetchLightPlace(int light) { return lightPlace[light]; }
#if !TETMARCH_SINGLE_LIGHT
uniform int lightCount;
uniform int lightKind[MOST_LIGHTS]; // 1: headlight
bool isHeadlight(int light) { return lightKind[light] == 1; }
#endif
#endif
#if TETMARCH_WORLD_LIGHTS
uniform mat3 worldMatrix;  // of vectors
uniform mat3 normalMatrix; // of gradients
vec3 toWorld(vec3 v) { return worldMatrix * v; }
vec3 toWorldNormal(vec3 gradient) { return normalMatrix * gradient; }
uniform vec4 lightAttenuation[MOST_LIGHTS];
uniform vec4 lightCone[MOST_LIGHTS];
vec4 fetchLightAttenuation(int light) { return lightAttenuation[light]; }
vec4 fetchLightCone(int light) { return lightCone[light]; }
#endif
#if TETMARCH_SCATTERING
uniform float scatteringBlending;
uniform float gradientUnit;
#endif
#if TETMARCH_SHADOWS
uniform float shadowStrength[MOST_LIGHTS];
uniform int shadowChannel[MOST_LIGHTS];
float fetchShadowStrength(int light) { return shadowStrength[light]; }
int fetchShadowChannel(int light) { return shadowChannel[light]; }
#endif
#endif

#if TETMARCH_VERTEX_LIGHT
#include "light/vertex_light_layout.glsl"
uniform sampler2D vertexLightTexture;
vec4 fetchVertexLight(uint vertex) { return texelFetch(vertexLightTexture, texelOfVertex(vertex), 0); }
#endif
