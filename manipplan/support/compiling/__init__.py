"""Machine code: from C by a compiler, from LLVM's language, and from Python by numba."""
