// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// One triangle that covers the picture; position is in [0, 1] with v = 0 at the bottom.
out vec2 position;

void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  position = corner;
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
