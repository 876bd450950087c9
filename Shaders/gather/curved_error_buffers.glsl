// How far tetrahedra are from the curved cells that were cut into them: faces from faces, and scalars at one place; bound
// by GL/MarchPass.
uniform vec2 curvedDeparture;
