"""CasADi expression -> instruction list -> LLVM IR -> native code in process, cached on disk.

The only room that knows CasADi's instruction list and llvmlite.
"""
