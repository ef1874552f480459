"""The articulated-body recursion of a general arm, as kernels: one per kind of joint and link, called in a schedule."""
