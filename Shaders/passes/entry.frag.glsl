// Writes where the pixel's ray enters the mesh: the nearest boundary face and the barycentric position in it.
//VTK::Output::Dec

flat in float face;
in vec3 share;

void main() { gl_FragData[0] = vec4(face, share); }
