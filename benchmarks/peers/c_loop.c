/* Classical RK4 of fixed step over a right-hand side with CasADi's calling convention:
 * argument 0 time, 1 state, 2 row of the reference [t_start, coefficients], 3 parameters; result 0 the rate of state.
 * FUNCTION and N are defined on top of this text, after the right-hand side itself, so the compiler may inline it. */
#include <stdlib.h>
#include <string.h>

#define STAGE(time, state, rate) (now = (time), arg[1] = (state), res[0] = (rate), FUNCTION(arg, res, iw, w, 0))

int peer_loop(long long steps, double step, double *y, long long pieces, const double *knots, const double *rows,
              long long row_length, const double *parameters)
{
    long long size_arg = 4, size_res = 1, size_iw = 1, size_w = 1;
    WORK(&size_arg, &size_res, &size_iw, &size_w);
    const double **arg = calloc(size_arg + 1, sizeof(*arg));
    double **res = calloc(size_res + 1, sizeof(*res));
    long long *iw = calloc(size_iw + 1, sizeof(*iw));
    double *w = calloc(size_w + 1, sizeof(*w));
    double k1[N], k2[N], k3[N], k4[N], x[N], now;
    long long piece = 0;
    int failed = 0;
    arg[0] = &now;
    arg[3] = parameters;
    for (long long i = 0; i < steps && !failed; i++) {
        double t = i * step;
        while (piece + 1 < pieces && t + 0.5 * step >= knots[piece + 1]) piece++;
        arg[2] = rows + piece * row_length;
        failed |= STAGE(t, y, k1);
        for (int j = 0; j < N; j++) x[j] = y[j] + 0.5 * step * k1[j];
        failed |= STAGE(t + 0.5 * step, x, k2);
        for (int j = 0; j < N; j++) x[j] = y[j] + 0.5 * step * k2[j];
        failed |= STAGE(t + 0.5 * step, x, k3);
        for (int j = 0; j < N; j++) x[j] = y[j] + step * k3[j];
        failed |= STAGE(t + step, x, k4);
        for (int j = 0; j < N; j++) y[j] += step / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
    }
    free(arg), free(res), free(iw), free(w);
    return failed;
}
