// An opaque surface in the light of distant lights, as vtkOpenGLPolyDataMapper lights it.
#include "language.glsl"

//VTK::Output::Dec

in vec3 viewPosition;
in vec3 viewNormal;
in vec4 pointColor;
in vec2 pointInTable;

uniform bool hasNormals; // else it is flat
uniform bool hasColors; // at points
uniform bool hasTable; // in place of them; with neither, colours are those of the material
uniform sampler2D colorTable;
uniform bool isLit;
uniform bool isParallel;
uniform bool isHeadlight; // and no other light
uniform int lightCount;
uniform vec3 lightDirections[8]; // in which they shine
uniform vec3 lightColors[8];
uniform vec3 ambientColor;
uniform vec3 diffuseColor;
uniform vec3 specularColor; // times its strength
uniform float ambient;
uniform float diffuse;
uniform float specularPower;

// The normal on the side of the eye.
vec3 flatNormal()
{
  vec3 across = normalize(cross(dFdx(viewPosition), dFdy(viewPosition)));
  float away = isParallel ? -across.z : dot(across, viewPosition);
  return away > 0.0 ? -across : across;
}

vec3 smoothNormal() { return gl_FrontFacing ? normalize(viewNormal) : -normalize(viewNormal); }

struct Reflected
{
  vec3 diffuse;
  vec3 specular;
};

// The shares of the light that are reflected. VTK takes the eye as far away if there is but a headlight.
Reflected reflected(vec3 across)
{
  Reflected sum = Reflected(vec3(0.0), vec3(0.0));
  vec3 towardsEye = normalize(-viewPosition);
  for (int i = 0; i < lightCount; ++i)
  {
    float facing = max(0.0, -dot(across, lightDirections[i]));
    float mirrored = isHeadlight ? facing : max(0.0, dot(reflect(lightDirections[i], across), towardsEye));
    sum.diffuse += facing * lightColors[i];
    sum.specular += (facing > 0.0 ? pow(mirrored, specularPower) : 0.0) * lightColors[i];
  }
  return sum;
}

void main()
{
  vec3 mapped = hasTable ? textureLod(colorTable, pointInTable, 0.0).rgb : pointColor.rgb;
  bool isMapped = hasTable || hasColors;
  vec3 ambientLight = ambient * (isMapped ? mapped : ambientColor);
  vec3 diffuseLight = diffuse * (isMapped ? mapped : diffuseColor);
  vec3 onPlane = flatNormal(); // derivatives need uniform control flow
  vec3 across = hasNormals ? smoothNormal() : onPlane;
  Reflected share = reflected(across);
  vec3 lit = ambientLight + share.diffuse * diffuseLight + share.specular * specularColor;
  gl_FragData[0] = vec4(isLit ? lit : ambientLight + diffuseLight, 1.0);
}
