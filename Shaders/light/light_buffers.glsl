// The lights; bound by GL/LightBinding. They are in the normalised frame of the mesh, or in the world with the centre of
// the mesh as origin.
uniform bool twoSided;
uniform vec3 ambientColor;
uniform float specularPower;
uniform vec3 lightDiffuse[MOST_LIGHTS]; // times the property's diffuse
uniform vec3 lightSpecular[MOST_LIGHTS]; // times the property's specular

vec3 fetchLightDiffuse(int light) { return lightDiffuse[light]; }
vec3 fetchLightSpecular(int light) { return lightSpecular[light]; }

#if !TETMARCH_HEADLIGHT_ONLY
uniform vec4 lightPlace[MOST_LIGHTS]; // unit vector to the light, 0; or its position, 1
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
uniform vec4 lightAttenuation[MOST_LIGHTS]; // see light/light_source.glsl
uniform vec4 lightCone[MOST_LIGHTS];
vec4 fetchLightAttenuation(int light) { return lightAttenuation[light]; }
vec4 fetchLightCone(int light) { return lightCone[light]; }
#endif
#if TETMARCH_SCATTERING
uniform float scatteringBlending; // half of VTK's, 0..1
#endif
#if TETMARCH_SHADOWS
uniform float shadowStrength[MOST_LIGHTS]; // see light/shadows.glsl
uniform int shadowChannel[MOST_LIGHTS];
float fetchShadowStrength(int light) { return shadowStrength[light]; }
int fetchShadowChannel(int light) { return shadowChannel[light]; }
#endif
