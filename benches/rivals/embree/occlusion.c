/* Whether anything is in the way of the rays of ../src/bin/occlusion.rs, by Embree; see ../occlusion.
 *
 *     cc -O2 -march=native -ffp-contract=off occlusion.c -o occlusion -lembree3 -lm -lpthread
 *     ./occlusion MESH.bin RAYS.bin THREADS ROUNDS
 *
 * Packets are filled from the rays where they lie, which is part of the time. A row: what, the least and
 * the median of the rounds in milliseconds, and hits as a check. */
#include "scene.h"
#include <pthread.h>

typedef struct { float origin[3], direction[3], range[2]; } Ray;

enum { CHUNK = 4096 };

typedef struct {
    RTCScene scene;
    const Ray *rays;
    long count, next, hits;
    long (*work)(RTCScene, const Ray *, long, enum RTCIntersectContextFlags);
    enum RTCIntersectContextFlags flags;
} Task;

static long one_by_one(RTCScene scene, const Ray *rays, long count, enum RTCIntersectContextFlags flags)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    long hits = 0;
    for (long at = 0; at < count; at++) {
        const float *o = rays[at].origin, *d = rays[at].direction;
        struct RTCRay ray = {.org_x = o[0], .org_y = o[1], .org_z = o[2], .dir_x = d[0], .dir_y = d[1],
                             .dir_z = d[2], .tnear = rays[at].range[0], .tfar = rays[at].range[1], .mask = ~0u};
        rtcOccluded1(scene, &context, &ray);
        hits += ray.tfar < 0;
    }
    return hits;
}

/* Packets of eight and of sixteen differ in their types alone. */
#define PACKETS(COUNT)                                                                             \
    static long packets_of_##COUNT(RTCScene scene, const Ray *rays, long count,                    \
                                   enum RTCIntersectContextFlags flags)                            \
    {                                                                                              \
        struct RTCIntersectContext context;                                                        \
        rtcInitIntersectContext(&context);                                                         \
        context.flags = flags;                                                                     \
        long hits = 0;                                                                             \
        for (long at = 0; at < count; at += COUNT) {                                               \
            _Alignas(64) struct RTCRay##COUNT packet;                                              \
            _Alignas(64) int valid[COUNT];                                                         \
            for (int lane = 0; lane < COUNT; lane++) {                                             \
                valid[lane] = at + lane < count ? -1 : 0;                                          \
                const Ray *ray = &rays[valid[lane] ? at + lane : at];                              \
                const float *o = ray->origin, *d = ray->direction;                                 \
                packet.org_x[lane] = o[0], packet.dir_x[lane] = d[0];                              \
                packet.org_y[lane] = o[1], packet.dir_y[lane] = d[1];                              \
                packet.org_z[lane] = o[2], packet.dir_z[lane] = d[2];                              \
                packet.tnear[lane] = ray->range[0], packet.tfar[lane] = ray->range[1];             \
                packet.time[lane] = 0, packet.mask[lane] = ~0u;                                    \
                packet.id[lane] = 0, packet.flags[lane] = 0;                                       \
            }                                                                                      \
            rtcOccluded##COUNT(valid, scene, &context, &packet);                                   \
            for (int lane = 0; lane < COUNT; lane++)                                               \
                hits += valid[lane] && packet.tfar[lane] < 0;                                      \
        }                                                                                          \
        return hits;                                                                               \
    }

PACKETS(8)
PACKETS(16)

static void *run(void *of)
{
    Task *task = of;
    long hits = 0;
    for (;;) {
        long first = __atomic_fetch_add(&task->next, CHUNK, __ATOMIC_RELAXED);
        if (first >= task->count)
            break;
        long count = task->count - first < CHUNK ? task->count - first : CHUNK;
        hits += task->work(task->scene, task->rays + first, count, task->flags);
    }
    __atomic_fetch_add(&task->hits, hits, __ATOMIC_RELAXED);
    return NULL;
}

int main(int count, char **words)
{
    Mesh mesh = count == 5 ? read_mesh(words[1]) : (Mesh){0};
    FILE *file = count == 5 ? fopen(words[2], "rb") : NULL;
    uint32_t counts[2];
    if (!mesh.triangles || !file || fread(counts, 4, 2, file) != 2) {
        fprintf(stderr, "usage: occlusion MESH.bin RAYS.bin THREADS ROUNDS\n");
        return 1;
    }
    size_t all = (size_t)counts[0] + counts[1];
    Ray *rays = malloc(all * sizeof *rays);
    if (!rays || fread(rays, sizeof *rays, all, file) != all) {
        fprintf(stderr, "the rays are too short\n");
        return 1;
    }
    int threads = atoi(words[3]), rounds = atoi(words[4]) > 0 ? atoi(words[4]) : 1;
    double *times = calloc((size_t)rounds, sizeof *times);
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = build(device, &mesh);
    for (int way = 0; way < 6; way++) {
        const char *names[] = {"Embree, one at a time", "Embree, packets of 8", "Embree, packets of 16"};
        int is_open = way / 3;
        ssize_t property = way % 3 == 2 ? rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) : 1;
        if (!property)
            continue;
        Task task = {.scene = scene, .rays = rays + (is_open ? counts[0] : 0), .count = counts[is_open],
                     .work = way % 3 == 0 ? one_by_one : way % 3 == 1 ? packets_of_8 : packets_of_16,
                     .flags = is_open ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
                                      : RTC_INTERSECT_CONTEXT_FLAG_COHERENT};
        for (int round = -1; round < rounds; round++) {
            pthread_t others[64];
            task.next = task.hits = 0;
            double start = now();
            for (int thread = 1; thread < threads && thread < 64; thread++)
                pthread_create(&others[thread], NULL, run, &task);
            run(&task);
            for (int thread = 1; thread < threads && thread < 64; thread++)
                pthread_join(others[thread], NULL);
            if (round >= 0)
                times[round] = now() - start;
        }
        char name[64];
        snprintf(name, sizeof name, "%s %s", is_open ? "openness" : "light", names[way % 3]);
        row(name, times, rounds, task.hits);
    }
    return 0;
}
