// An opaque surface in the light of one headlight, as vtkOpenGLPolyDataMapper lights it.
#include "language.glsl"

//VTK::Output::Dec

in vec3 viewPosition;
in vec3 viewNormal;
in vec4 pointColor;

uniform bool hasNormals; // else it is flat
uniform bool hasColors; // else they are those of the material
uniform bool isLit;
uniform bool isParallel;
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

void main()
{
  vec3 ambientLight = ambient * (hasColors ? pointColor.rgb : ambientColor);
  vec3 diffuseLight = diffuse * (hasColors ? pointColor.rgb : diffuseColor);
  vec3 onPlane = flatNormal(); // derivatives need uniform control flow
  float facing = max(0.0, hasNormals ? smoothNormal().z : onPlane.z);
  float glossy = facing > 0.0 ? pow(facing, specularPower) : 0.0;
  vec3 lit = ambientLight + facing * diffuseLight + glossy * specularColor;
  gl_FragData[0] = vec4(isLit ? lit : ambientLight + diffuseLight, 1.0);
}
