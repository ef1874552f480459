/* The calls of NVIDIA's driver that cuda-core makes here, on the memory and the processor of this machine.

   A launch calls the function at the address STAND_IN_CASE for each thread, with the kernel's 23 arguments of 8 bytes.
   Numbers of attributes: compute capability 75 and 76, multiprocessors 16, threads of each 39; local memory 3. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t W;
typedef void (*Case)(W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W, W);

static int launches, taken;
int stand_in_launches(void) { return launches; }
int stand_in_taken(void) { return taken; }

int cuInit(unsigned flags) { return 0; }
int cuDriverGetVersion(int *version) { *version = 12090; return 0; }
int cuDeviceGetCount(int *count) { *count = 1; return 0; }
int cuDeviceGet(int *device, int index) { *device = index; return 0; }
int cuDeviceGetName(char *name, int size, int device) { snprintf(name, size, "stand-in"); return 0; }
int cuDeviceGetAttribute(int *value, int which, int device) {
  *value = which == 75 ? 9 : which == 76 ? 0 : which == 16 ? 4 : which == 39 ? 2048 : 1;
  return 0;
}
int cuDevicePrimaryCtxRetain(void **context, int device) { *context = &launches; return 0; }
int cuDevicePrimaryCtxRelease_v2(int device) { return 0; }
int cuCtxSetCurrent(void *context) { return 0; }
int cuCtxGetCurrent(void **context) { *context = &launches; return 0; }
int cuCtxGetDevice(int *device) { *device = 0; return 0; }
int cuCtxGetStreamPriorityRange(int *least, int *most) { *least = 0; *most = -1; return 0; }

int cuStreamCreateWithPriority(void **stream, unsigned flags, int priority) { *stream = &taken; return 0; }
int cuStreamDestroy_v2(void *stream) { return 0; }
int cuStreamSynchronize(void *stream) { return 0; }
int cuStreamGetCtx(void *stream, void **context) { *context = &launches; return 0; }

int cuMemGetInfo_v2(size_t *free, size_t *total) { *free = *total = 1 << 29; return 0; }
int cuMemAlloc_v2(W *room, size_t size) { *room = (W)malloc(size); taken++; return 0; }
int cuMemFree_v2(W room) { free((void *)room); taken--; return 0; }
int cuMemcpyHtoDAsync_v2(W room, void *from, size_t size, void *stream) { memcpy((void *)room, from, size); return 0; }
int cuMemcpyDtoHAsync_v2(void *to, W room, size_t size, void *stream) { memcpy(to, (void *)room, size); return 0; }

int cuLibraryLoadData(void **library, void *code, void *a, void *b, unsigned c, void *d, void *e, unsigned f) {
  *library = &launches;
  return strstr(code, ".visible .entry run(") ? 0 : 218;
}
int cuLibraryUnload(void *library) { return 0; }
int cuLibraryGetKernel(void **kernel, void *library, char *name) { *kernel = &taken; return strcmp(name, "run") ? 500 : 0; }
int cuKernelGetFunction(void **function, void *kernel) { *function = kernel; return 0; }
int cuKernelGetLibrary(void **library, void *kernel) { *library = &launches; return 0; }
int cuKernelGetAttribute(int *value, int which, void *kernel, int device) { *value = which == 3 ? 8240 : 1; return 0; }
int cuGetErrorName(int error, const char **text) { *text = "CUDA_ERROR"; return 0; }
int cuGetErrorString(int error, const char **text) { *text = "an error"; return 0; }

static int run(unsigned grid, unsigned block, void **given) {
  Case one = (Case)strtoull(getenv("STAND_IN_CASE"), 0, 10);
  W a[23];
  for (int k = 0; k < 23; k++) memcpy(&a[k], given[k], 8);
  for (W thread = 0; thread < (W)grid * block; thread++)
    one(thread, a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8], a[9], a[10], a[11], a[12], a[13], a[14], a[15],
        a[16], a[17], a[18], a[19], a[20], a[21], a[22]);
  launches++;
  return 0;
}
int cuLaunchKernel(void *function, unsigned grid, unsigned gy, unsigned gz, unsigned block, unsigned by, unsigned bz,
                   unsigned shared, void *stream, void **given, void **more) {
  return run(grid, block, given);
}
typedef struct { unsigned grid, gy, gz, block, by, bz, shared; void *stream, *attributes; unsigned count; } Config;
int cuLaunchKernelEx(const Config *config, void *function, void **given, void **more) {
  return run(config->grid, config->block, given);
}

/* Where a function is, by its name, that of its second version first; none where it is not needed here. */
int cuGetProcAddress_v2(const char *name, void **address, int version, uint64_t flags, int *status) {
  char second[200];
  void *self = dlopen("libcuda.so.1", RTLD_NOW | RTLD_NOLOAD);
  snprintf(second, sizeof second, "%s_v2", name);
  *address = dlsym(self, second);
  if (!*address) *address = dlsym(self, name);
  if (status) *status = *address ? 0 : 1;
  return 0;
}
