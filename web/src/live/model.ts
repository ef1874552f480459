// A robot's compiled equations for anybody's page: what `tmodes export --wasm` ships beside the module itself.

export * from "./engine";
export * from "./engine_run";
