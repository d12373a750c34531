#include "bench/paper_method.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

namespace snug::bench {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 to_clip;
void main() { gl_Position = to_clip * vec4(position, 1.0); }
)";
constexpr const char* kFragmentShader = "#version 330 core\nvoid main() {}\n";

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "OSMesa: %s\n", what);
    std::exit(1);
}

GLuint compiled(GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    require(done != 0, "a shader does not compile");
    return shader;
}

/// Design coordinates to clip space, column-major: y and z of the space over the picture, x into its depth.
std::array<float, 16> to_clip(const Placement& placement, Vec3d half) {
    const std::array<Vec3d, 3>& row = placement.rotation.row;
    const auto line = [&](int axis) {
        const Vec3d turned = row[static_cast<std::size_t>(axis)] * (1 / half[axis]);
        return std::array<double, 4>{turned.x, turned.y, turned.z, placement.shift[axis] / half[axis]};
    };
    const std::array<std::array<double, 4>, 3> lines{line(2), line(1), line(0)};
    std::array<float, 16> matrix{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) matrix[j * 4 + i] = static_cast<float>(lines[i][j]);
    matrix[15] = 1;
    return matrix;
}

}  // namespace

struct PaperMethod::Context {
    OSMesaContext mesa = nullptr;
    int texels = 0;
    GLsizei indices = 0;
    GLint matrix = -1;
    std::vector<unsigned char> colours;  ///< OSMesa wants a picture, too
    std::vector<float> nearest, farthest;

    ~Context() { OSMesaDestroyContext(mesa); }

    void draw(GLenum keep, double cleared, std::vector<float>& depths) {
        glClearDepth(cleared);
        glDepthFunc(keep);
        glClear(GL_DEPTH_BUFFER_BIT);
        glDrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, nullptr);
        glReadPixels(0, 0, texels, texels, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    }
};

PaperMethod::PaperMethod(const Mesh& mesh, int texels) : context_(std::make_unique<Context>()) {
    Context& c = *context_;
    const std::array attributes{OSMESA_FORMAT,
                                OSMESA_RGBA,
                                OSMESA_DEPTH_BITS,
                                24,
                                OSMESA_PROFILE,
                                OSMESA_CORE_PROFILE,
                                OSMESA_CONTEXT_MAJOR_VERSION,
                                3,
                                OSMESA_CONTEXT_MINOR_VERSION,
                                3,
                                0};
    c.mesa = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    require(c.mesa != nullptr, "no context");
    const auto pixels = static_cast<std::size_t>(texels) * static_cast<std::size_t>(texels);
    c.texels = texels;
    c.colours.resize(pixels * 4);
    c.nearest.resize(pixels);
    c.farthest.resize(pixels);
    require(OSMesaMakeCurrent(c.mesa, c.colours.data(), GL_UNSIGNED_BYTE, texels, texels) != 0, "no picture");

    GLuint array = 0;
    std::array<GLuint, 2> buffers{};
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(2, buffers.data());
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vec3f)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(Triangle)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    c.indices = static_cast<GLsizei>(mesh.triangles.size() * 3);

    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, kVertexShader));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, kFragmentShader));
    glLinkProgram(program);
    glUseProgram(program);
    c.matrix = glGetUniformLocation(program, "to_clip");
    require(c.matrix >= 0, "the program does not link");
    glViewport(0, 0, texels, texels);
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
}

PaperMethod::~PaperMethod() = default;

const char* PaperMethod::renderer() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

DepthMap PaperMethod::depth_map(const Placement& placement, const DesignSpace& space) {
    Context& c = *context_;
    const Vec3d half = space.size() * 0.5;
    glUniformMatrix4fv(c.matrix, 1, GL_FALSE, to_clip(placement, half).data());
    c.draw(GL_LESS, 1, c.nearest);
    c.draw(GL_GREATER, 0, c.farthest);

    DepthMap depths(space.blocks.y, space.blocks.z);
    const auto x_of = [&](float depth) { return (2.0 * static_cast<double>(depth) - 1) * half.x; };
    for (int j = 0; j < space.blocks.y; ++j) {
        // Every texel that lies in the column, if only in part.
        const int top = j * c.texels / space.blocks.y;
        const int bottom = ((j + 1) * c.texels + space.blocks.y - 1) / space.blocks.y;
        for (int k = 0; k < space.blocks.z; ++k) {
            const int left = k * c.texels / space.blocks.z;
            const int right = ((k + 1) * c.texels + space.blocks.z - 1) / space.blocks.z;
            for (int v = top; v < bottom; ++v) {
                const float* const row = &c.nearest[static_cast<std::size_t>(v * c.texels)];
                const float* const far_row = &c.farthest[static_cast<std::size_t>(v * c.texels)];
                for (int u = left; u < right; ++u) {
                    if (row[u] >= 1) continue;  // nothing was drawn here
                    depths(j, k).include(x_of(row[u]));
                    depths(j, k).include(x_of(far_row[u]));
                }
            }
        }
    }
    return depths;
}

}  // namespace snug::bench
