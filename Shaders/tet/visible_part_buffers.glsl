// The tetrahedra that may be visible, and the faces through which rays enter them; Entries/VisiblePart.h.
uniform usamplerBuffer visibleTetBuffer;  // one bit per tetrahedron
uniform usamplerBuffer visibleFaceBuffer; // three vertices counter-clockwise from outside, half-face inside
uniform usamplerBuffer visibleLinkBuffer; // the link of that half-face

uint fetchVisibleTets(uint word) { return BUFFER_TEXEL(visibleTetBuffer, int(word)).x; }
uvec4 fetchVisibleFace(uint face) { return BUFFER_TEXEL(visibleFaceBuffer, int(face)); }
uint fetchVisibleLink(uint face) { return BUFFER_TEXEL(visibleLinkBuffer, int(face)).x; }
