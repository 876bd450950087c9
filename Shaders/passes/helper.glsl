// Helper invocations: pixels beside the triangle that is drawn, to fill a group that is worked on together.
//
// With a newer llvmpipe they are to stay out of loops. What is the same for all pixels of a group, that of Mesa 26.1
// takes after a loop from the group's first pixel, even if that is a helper that was still in the loop when the others
// had left it; then it is wrong for all of them.
#if TETMARCH_SKIPS_HELPERS
#extension GL_ARB_ES3_1_compatibility : require
#define IS_HELPER gl_HelperInvocation
#else
#define IS_HELPER false
#endif
