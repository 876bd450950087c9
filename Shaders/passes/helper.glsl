// Helper invocations: pixels beside the drawn triangle. They complete a group of pixels that runs in lockstep.
//
// With a newer llvmpipe helpers must not enter loops. After a loop, the llvmpipe of Mesa 26.1 takes a value that is
// equal in all pixels of a group from the group's first pixel, even if that is a helper that was still in the loop when
// the others had left it; then the value is wrong for all of them.
#if TETMARCH_SKIPS_HELPERS
#define IS_HELPER gl_HelperInvocation
#else
#define IS_HELPER false
#endif
