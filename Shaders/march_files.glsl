// The march of the picture, in the order in which its files use each other.
#include "traversal_files.glsl"
#if TETMARCH_LIT
#include "light.glsl"
#endif
#if TETMARCH_COMPOSITE || TETMARCH_ISOSURFACES
#include "radiance.glsl"
#endif
#if TETMARCH_COMPOSITE
#include "absorption.glsl"
#endif
#if TETMARCH_EFFECTS
#include "effects.glsl"
#endif
#include "passage.glsl"
#include "gather_files.glsl"
#if TETMARCH_SAMPLED_SHADOWS
#include "tet.glsl"
#endif
#if TETMARCH_CROPPED
#include "cropping.glsl"
#endif
#if TETMARCH_PICKED
#include "pick_piece.glsl"
#endif
#include "march.glsl"
