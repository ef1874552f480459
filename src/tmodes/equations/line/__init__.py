"""The elastic line of every link as expressions: one schedule, compiled to native code and to WebAssembly."""
