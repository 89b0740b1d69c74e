/* Closest hits by Embree, on the mesh and the rays of src/lib.rs; see ../rays.
 *
 *     cc -O2 -march=native -ffp-contract=off rays.c -o rays -lembree3 -lm
 *     ./rays MESH.bin THREADS ROUNDS
 *
 * THREADS build the tree; rays are one thread's. A row: what, and the least and the median of the
 * rounds in milliseconds, and hits as a check. */
#include "scene.h"

enum { WIDTH = 1280, HEIGHT = 720, RAYS = WIDTH * HEIGHT };

typedef struct { float origin[3], direction[3]; } Ray;

static void camera_rays(Ray *rays)
{
    float half = tanf(22.5f * 3.14159265f / 180.0f);
    for (int tile = 0; tile < WIDTH / 8 * (HEIGHT / 8); tile++)
        for (int pixel = 0; pixel < 64; pixel++) {
            float x = (float)(tile % (WIDTH / 8) * 8 + pixel % 8) + 0.5f;
            float y = (float)(tile / (WIDTH / 8) * 8 + pixel / 8) + 0.5f;
            float dx = half * WIDTH / HEIGHT * (2 * x / WIDTH - 1), dy = half * (1 - 2 * y / HEIGHT);
            float scale = 1 / sqrtf(dx * dx + dy * dy + 1);
            *rays++ = (Ray){{0, 0, 3}, {dx * scale, dy * scale, -scale}};
        }
}

static uint64_t state = 12345;

static float next(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (float)(state >> 40) / (float)(1 << 24);
}

static void in_ball(float place[3], int on_surface)
{
    for (;;) {
        float squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = 2 * next() - 1;
            squared += place[axis] * place[axis];
        }
        if (squared > 1 || squared < 1e-4f)
            continue;
        for (int axis = 0; on_surface && axis < 3; axis++)
            place[axis] *= 1.5f / sqrtf(squared);
        return;
    }
}

static void chords(Ray *rays)
{
    for (int at = 0; at < RAYS; at++) {
        float to[3], squared = 0;
        in_ball(rays[at].origin, 1);
        in_ball(to, 0);
        for (int axis = 0; axis < 3; axis++) {
            to[axis] -= rays[at].origin[axis];
            squared += to[axis] * to[axis];
        }
        for (int axis = 0; axis < 3; axis++)
            rays[at].direction[axis] = to[axis] / sqrtf(squared);
    }
}

static long one_by_one(RTCScene scene, const Ray *rays, enum RTCIntersectContextFlags flags)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    long hits = 0;
    for (int at = 0; at < RAYS; at++) {
        const float *o = rays[at].origin, *d = rays[at].direction;
        struct RTCRayHit ray;
        ray.ray = (struct RTCRay){.org_x = o[0], .org_y = o[1], .org_z = o[2], .dir_x = d[0],
                                  .dir_y = d[1], .dir_z = d[2], .tfar = INFINITY, .mask = ~0u};
        ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &ray);
        hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
}

/* Packets of eight and of sixteen differ in their types alone. */
#define PACKETS(COUNT)                                                                             \
    static long packets_of_##COUNT(RTCScene scene, const Ray *rays)                                \
    {                                                                                              \
        struct RTCIntersectContext context;                                                        \
        rtcInitIntersectContext(&context);                                                         \
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;                                       \
        _Alignas(64) int valid[COUNT];                                                             \
        memset(valid, -1, sizeof valid);                                                           \
        long hits = 0;                                                                             \
        for (int at = 0; at < RAYS; at += COUNT) {                                                 \
            _Alignas(64) struct RTCRayHit##COUNT packet;                                           \
            for (int lane = 0; lane < COUNT; lane++) {                                             \
                const float *o = rays[at + lane].origin, *d = rays[at + lane].direction;           \
                packet.ray.org_x[lane] = o[0], packet.ray.dir_x[lane] = d[0];                      \
                packet.ray.org_y[lane] = o[1], packet.ray.dir_y[lane] = d[1];                      \
                packet.ray.org_z[lane] = o[2], packet.ray.dir_z[lane] = d[2];                      \
                packet.ray.tnear[lane] = 0, packet.ray.tfar[lane] = INFINITY;                      \
                packet.ray.time[lane] = 0, packet.ray.mask[lane] = ~0u;                            \
                packet.ray.id[lane] = 0, packet.ray.flags[lane] = 0;                               \
                packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;                                 \
                packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;                              \
            }                                                                                      \
            rtcIntersect##COUNT(valid, scene, &context, &packet);                                  \
            for (int lane = 0; lane < COUNT; lane++)                                               \
                hits += packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;                        \
        }                                                                                          \
        return hits;                                                                               \
    }

PACKETS(8)
PACKETS(16)

int main(int count, char **words)
{
    Mesh mesh = count == 4 ? read_mesh(words[1]) : (Mesh){0};
    Ray *camera = malloc(RAYS * sizeof *camera), *random = malloc(RAYS * sizeof *random);
    char config[32];
    if (!mesh.triangles || !camera || !random) {
        fprintf(stderr, "usage: rays MESH.bin THREADS ROUNDS\n");
        return 1;
    }
    int rounds = atoi(words[3]) > 0 ? atoi(words[3]) : 1, threads = atoi(words[2]);
    double *times = calloc((size_t)rounds, sizeof *times);
    snprintf(config, sizeof config, "threads=%d", threads);
    RTCDevice device = rtcNewDevice(config);
    RTCScene scene = build(device, &mesh);
    for (int round = 0; round < rounds; round++) {
        rtcReleaseScene(scene);
        double start = now();
        scene = build(device, &mesh);
        times[round] = now() - start;
    }
    row("build Embree", times, rounds, (long)mesh.triangles);
    if (threads > 1)
        return 0;
    camera_rays(camera);
    chords(random);
    long hits = 0;
    for (int way = 0; way < 4; way++) {
        const char *names[] = {"camera Embree, one at a time", "camera Embree, packets of 8",
                               "camera Embree, packets of 16", "random Embree, one at a time"};
        ssize_t property = way == 1   ? rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)
                           : way == 2 ? rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)
                                      : 1;
        for (int round = -1; property && round < rounds; round++) {
            double start = now();
            hits = way == 1   ? packets_of_8(scene, camera)
                   : way == 2 ? packets_of_16(scene, camera)
                   : way == 0 ? one_by_one(scene, camera, RTC_INTERSECT_CONTEXT_FLAG_COHERENT)
                              : one_by_one(scene, random, RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
            if (round >= 0)
                times[round] = now() - start;
        }
        if (property)
            row(names[way], times, rounds, hits);
    }
    return 0;
}
