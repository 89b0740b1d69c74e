/* Meshes of src/mesh.rs for Embree, times, and rows of both programs here. */
#include <embree3/rtcore.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    float *places;
    uint32_t *corners;
    size_t vertices, triangles;
} Mesh;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void row(const char *name, double *times, int rounds, long hits)
{
    qsort(times, (size_t)rounds, sizeof *times, by_size);
    printf("%s\t%.3f\t%.3f\t%ld\n", name, times[0], times[rounds / 2], hits);
    fflush(stdout);
}

/* Without triangles if the file is none or too short. */
static Mesh read_mesh(const char *path)
{
    Mesh mesh = {0};
    char magic[4];
    uint32_t counts[2];
    FILE *file = fopen(path, "rb");
    if (!file || fread(magic, 1, 4, file) != 4 || memcmp(magic, "CHM1", 4) || fread(counts, 4, 2, file) != 2)
        return mesh;
    mesh.places = calloc(3 * (size_t)counts[0] + 4, sizeof *mesh.places);
    mesh.corners = calloc(3 * (size_t)counts[1], sizeof *mesh.corners);
    if (mesh.places && mesh.corners && fread(mesh.places, 12, counts[0], file) == counts[0]
        && !fseek(file, 12 * (long)counts[0], SEEK_CUR)
        && fread(mesh.corners, 12, counts[1], file) == counts[1])
        mesh.vertices = counts[0], mesh.triangles = counts[1];
    fclose(file);
    return mesh;
}

static RTCScene build(RTCDevice device, const Mesh *mesh)
{
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh->places, 0, 12,
                               mesh->vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh->corners, 0, 12,
                               mesh->triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}
