#include <frob/elementary.h>
float frob_expf(float x) { return (float)frob_exp(x); }
float frob_logf(float x) { return (float)frob_log(x); }
float frob_sinf(float x) { return (float)frob_sin(x); }
float frob_cosf(float x) { return (float)frob_cos(x); }
float frob_tanf(float x) { return (float)frob_tan(x); }
float frob_asinf(float x) { return (float)frob_asin(x); }
float frob_acosf(float x) { return (float)frob_acos(x); }
float frob_atanf(float x) { return (float)frob_atan(x); }
float frob_powf(float x, float y) { return (float)frob_pow(x, y); }
float frob_atan2f(float x, float y) { return (float)frob_atan2(x, y); }
float frob_hypotf(float x, float y) { return (float)frob_hypot(x, y); }
