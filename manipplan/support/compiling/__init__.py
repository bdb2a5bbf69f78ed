"""Machine code: from C by a compiler, and from LLVM's language."""
