// Where the pixel's ray enters the mesh: the nearest boundary face, and the barycentrics in it.
//VTK::Output::Dec

flat in float face;
in vec3 barycentrics;

void main() { gl_FragData[0] = vec4(face, barycentrics); }
