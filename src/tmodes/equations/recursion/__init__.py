"""The articulated-body recursion of any robot, as kernels: one per kind of joint and link, called in a schedule."""
