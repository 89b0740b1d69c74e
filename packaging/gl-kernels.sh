# Which kernels the libraries of OpenGL have; sourced by packaging/gl and .ci/gl, whose builds then share what they compile.
# One copy less, of the largest code: machines without AVX2 run the kernels of SSE2.
export RUSTFLAGS="${RUSTFLAGS:-} --cfg disable_dispatch_sse4_2"
