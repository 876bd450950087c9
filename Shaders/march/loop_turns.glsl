// Mesa's llvmpipe ends a shader after 65,535 turns of all loops, for eight rays together: rays that take samples of the
// light count theirs.
int loopTurns = 0;

void countTurns(int turns) { loopTurns = loopTurns + turns; }
