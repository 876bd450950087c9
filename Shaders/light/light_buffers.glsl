// The lights; bound by GL/LightBinding. They are in the normalised frame of the mesh, or in the world with the centre of
// the mesh as origin. The software renderer keeps those of few lights, as in tables/table_buffers.glsl.
uniform float givenBackSide;
uniform vec3 givenAmbient;
uniform float givenSpecularPower;
// In images, global variables would take registers of a GPU.
#if TETMARCH_STRUCTURED || TETMARCH_ES
#define backSide givenBackSide
#define ambientColor givenAmbient
#define specularPower givenSpecularPower
#else
float backSide = KEPT(givenBackSide); // 1 if the back sides of surfaces are lit, too; else 0
vec3 ambientColor = KEPT(givenAmbient);
float specularPower = KEPT(givenSpecularPower);
#endif

#if TETMARCH_FEW_LIGHTS
#define KEPT_LIGHTS(T, lights) \
  T[5](KEPT(lights[0]), KEPT(lights[1]), KEPT(lights[2]), KEPT(lights[3]), KEPT(lights[4]))
#define KEPT_COUNT 5
#else
#define KEPT_LIGHTS(T, lights) T[1](KEPT(lights[0]))
#define KEPT_COUNT 1
#endif

uniform vec3 lightDiffuse[MOST_LIGHTS]; // times the property's diffuse
uniform vec3 lightSpecular[MOST_LIGHTS]; // times the property's specular
#if TETMARCH_KEEPS_LIGHTS
vec3 keptDiffuse[KEPT_COUNT] = KEPT_LIGHTS(vec3, lightDiffuse);
vec3 keptSpecular[KEPT_COUNT] = KEPT_LIGHTS(vec3, lightSpecular);
vec3 fetchLightDiffuse(int light) { return keptDiffuse[light]; }
vec3 fetchLightSpecular(int light) { return keptSpecular[light]; }
#else
vec3 fetchLightDiffuse(int light) { return lightDiffuse[light]; }
vec3 fetchLightSpecular(int light) { return lightSpecular[light]; }
#endif

#if !TETMARCH_HEADLIGHT_ONLY
uniform vec4 lightPlace[MOST_LIGHTS]; // unit vector to the light, 0; or its position, 1
#if TETMARCH_KEEPS_LIGHTS
vec4 keptPlace[KEPT_COUNT] = KEPT_LIGHTS(vec4, lightPlace);
vec4 fetchLightPlace(int light) { return keptPlace[light]; }
#else
vec4 fetchLightPlace(int light) { return lightPlace[light]; }
#endif
#if !TETMARCH_SINGLE_LIGHT
uniform int lightCount;
uniform float lightKind[MOST_LIGHTS]; // 1: headlight; else 0
#if TETMARCH_KEEPS_LIGHTS
float keptKind[KEPT_COUNT] = KEPT_LIGHTS(float, lightKind);
bool isHeadlight(int light) { return keptKind[light] > 0.5; }
#else
bool isHeadlight(int light) { return lightKind[light] > 0.5; }
#endif
#endif
#endif
#if TETMARCH_WORLD_LIGHTS
uniform mat3 worldMatrix;  // of vectors
uniform mat3 normalMatrix; // of gradients
vec3 toWorld(vec3 v) { return worldMatrix * v; }
vec3 toWorldNormal(vec3 gradient) { return normalMatrix * gradient; }
uniform vec4 lightAttenuation[MOST_LIGHTS]; // see light/light_source.glsl
uniform vec4 lightCone[MOST_LIGHTS];
#if TETMARCH_KEEPS_LIGHTS
vec4 keptAttenuation[KEPT_COUNT] = KEPT_LIGHTS(vec4, lightAttenuation);
vec4 keptCone[KEPT_COUNT] = KEPT_LIGHTS(vec4, lightCone);
vec4 fetchLightAttenuation(int light) { return keptAttenuation[light]; }
vec4 fetchLightCone(int light) { return keptCone[light]; }
#else
vec4 fetchLightAttenuation(int light) { return lightAttenuation[light]; }
vec4 fetchLightCone(int light) { return lightCone[light]; }
#endif
#endif
#if TETMARCH_LIGHT_TOLERANCE
uniform float lightTolerance; // of a channel by the error of light, 0..1
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
