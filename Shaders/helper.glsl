// Helper invocations: pixels beside the triangle that is drawn, to fill a group that is worked on together.
//
// They are to stay out of loops. What is the same for all pixels of a group, Mesa 26.1's llvmpipe takes after a loop
// from the group's first pixel, even if that is a helper that was still in the loop when the others had left it; then
// it is wrong for all of them. Other drivers than Mesa's need no such care and may not know the name at this version.
#define IS_HELPER false
#ifdef GL_MESA_shader_integer_functions
#ifdef GL_ARB_ES3_1_compatibility
#extension GL_ARB_ES3_1_compatibility : enable
#undef IS_HELPER
#define IS_HELPER gl_HelperInvocation
#endif
#endif
