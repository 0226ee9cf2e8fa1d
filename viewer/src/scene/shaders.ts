// SPDX-License-Identifier: MIT
//
// Vertices are not sent: a shader is given the number of a corner, gl_VertexID, and looks up the
// simplex and its points in textures. So index buffers alone say what is drawn, and every simplex
// has a place of its own to be moved and coloured by.

const kCommon = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;

uniform mat4 view;        // from scene to eye
uniform mat4 projection;
uniform vec4 clipPlane;   // scene; what is above it is not drawn
uniform vec2 viewport;    // pixels
uniform float explosion;  // how far things move apart, 0 for not at all
uniform bool explodesParts;  // components, by the points' offsets; else every simplex for itself
uniform sampler2D points;   // x, y, z, weight
uniform sampler2D offsets;  // where a point's component goes; way to it from the wave's source
uniform sampler2D colours;  // of points

ivec2 texel(int i) { return ivec2(i & 2047, i >> 11); }

vec3 placed(int point) {
  vec3 p = texelFetch(points, texel(point), 0).xyz;
  if (explosion > 0.0 && explodesParts) p += explosion * texelFetch(offsets, texel(point), 0).xyz;
  return p;
}
vec3 colourOf(int point) { return texelFetch(colours, texel(point), 0).rgb; }
float wayTo(int point) { return texelFetch(offsets, texel(point), 0).w; }
`;

const kFragmentCommon = /* glsl */ `
precision highp float;
uniform vec4 clipPlane;
uniform float wave;       // the front's way; below 0 without
uniform vec3 fog;         // colour of what is far
uniform vec2 fogRange;    // eye distances
uniform float opacity;
uniform bool isOrthographic;

out vec4 pixel;

vec3 linear(vec3 c) { return c * c * (0.305306 * c + 0.682171) + 0.012522878 * c; }
vec3 display(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)); }

// A key light from above the left shoulder, a weak one from the right, light from all around that
// is stronger above, and a sheen. The normal looks to the eye.
vec3 lit(vec3 colour, vec3 normal, vec3 toEye) {
  float key = max(0.0, dot(normal, normalize(vec3(-0.45, 0.75, 0.6))));
  float side = max(0.0, dot(normal, normalize(vec3(0.85, -0.15, 0.35))));
  float around = 0.5 + 0.5 * normal.y;
  float sheen = pow(max(0.0, dot(normal, normalize(normalize(vec3(-0.45, 0.75, 0.6)) + toEye))), 36.0);
  float edge = pow(1.0 - max(0.0, dot(normal, toEye)), 3.0);
  vec3 light = vec3(1.0, 0.985, 0.96) * 0.72 * key + vec3(0.75, 0.85, 1.0) * 0.16 * side +
               mix(vec3(0.25, 0.24, 0.26), vec3(0.42, 0.44, 0.47), around);
  return linear(colour) * light + 0.10 * sheen + 0.05 * edge;
}

vec3 withFog(vec3 colour, float eyeDistance) {
  float share = clamp((eyeDistance - fogRange.x) / (fogRange.y - fogRange.x), 0.0, 1.0);
  return mix(colour, linear(fog), 0.62 * share * share);
}

vec3 withWave(vec3 colour, float way) {
  if (wave < 0.0) return colour;
  float behind = wave - way;
  vec3 faded = mix(colour, vec3(dot(colour, vec3(0.33))), 0.85) * 0.55 + 0.1;
  vec3 here = behind < 0.0 ? faded : colour;
  return mix(here, vec3(1.0, 0.84, 0.35), exp(-pow(behind / 0.035, 2.0)));
}
`;

export const kTriangleVertex = /* glsl */ `
${kCommon}
uniform usampler2D corners;      // of simplices
uniform sampler2D ownColours;    // of simplices
uniform vec3 colour;
uniform int colouring;           // 0 one colour, 1 that of the nearest point, 2 the simplex's own
uniform bool isSolid;            // simplices are tetrahedra, 12 corners of faces each
uniform bool hasInside;          // backs are the inside of the shape

flat out vec3 normal;
flat out vec3 colour0;
flat out vec3 colour1;
flat out vec3 colour2;
out vec3 share;
out vec3 eyePlace;
out vec3 scenePlace;
out float way;

const int kFaces[12] = int[12](1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1);

void main() {
  int width = isSolid ? 12 : 3;
  int simplex = gl_VertexID / width;
  int corner = gl_VertexID - width * simplex;
  uvec4 all = texelFetch(corners, texel(simplex), 0);
  ivec3 face = ivec3(all.xyz);
  if (isSolid) {
    int first = corner / 3 * 3;
    face = ivec3(all[kFaces[first]], all[kFaces[first + 1]], all[kFaces[first + 2]]);
    corner -= first;
  }
  vec3 place[3] = vec3[3](placed(face.x), placed(face.y), placed(face.z));
  if (explosion > 0.0 && !explodesParts) {
    vec3 middle = isSolid ? (placed(int(all.x)) + placed(int(all.y)) + placed(int(all.z)) + placed(int(all.w))) / 4.0
                          : (place[0] + place[1] + place[2]) / 3.0;
    for (int i = 0; i < 3; ++i) place[i] += explosion * middle;
  }
  vec3 eye0 = (view * vec4(place[0], 1.0)).xyz;
  vec3 eye1 = (view * vec4(place[1], 1.0)).xyz;
  vec3 eye2 = (view * vec4(place[2], 1.0)).xyz;
  normal = cross(eye1 - eye0, eye2 - eye0);
  colour0 = colour1 = colour2 = colour;
  if (colouring == 1) {
    colour0 = colourOf(face.x);
    colour1 = colourOf(face.y);
    colour2 = colourOf(face.z);
  } else if (colouring == 2) {
    colour0 = colour1 = colour2 = texelFetch(ownColours, texel(simplex), 0).rgb;
  }
  share = vec3(corner == 0, corner == 1, corner == 2);
  scenePlace = place[corner];
  eyePlace = corner == 0 ? eye0 : corner == 1 ? eye1 : eye2;
  way = wayTo(corner == 0 ? face.x : corner == 1 ? face.y : face.z);
  gl_Position = projection * vec4(eyePlace, 1.0);
  // The far side of a flat tetrahedron must not shine through its near side.
  vec3 toEye = projection[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : -eye0;
  if (hasInside && dot(normal, toEye) < 0.0) gl_Position.z += 1e-4 * gl_Position.w;
}
`;

export const kTriangleFragment = /* glsl */ `
${kFragmentCommon}
uniform bool isPlanar;     // no light
uniform bool hasInside;    // backs are the inside of the shape
uniform float outline;     // strength of the triangles' sides
flat in vec3 normal;
flat in vec3 colour0;
flat in vec3 colour1;
flat in vec3 colour2;
in vec3 share;
in vec3 eyePlace;
in vec3 scenePlace;
in float way;

void main() {
  if (dot(clipPlane, vec4(scenePlace, 1.0)) > 0.0) discard;
  vec3 colour = share.x > share.y && share.x > share.z ? colour0 : share.y > share.z ? colour1 : colour2;
  vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-eyePlace);
  vec3 n = normalize(normal);
  bool isBack = dot(n, toEye) < 0.0;
  if (isBack) n = -n;
  vec3 light;
  if (isPlanar) {
    light = linear(colour);
  } else {
    if (isBack && hasInside) colour = mix(colour, vec3(0.55, 0.5, 0.48), 0.4);
    light = lit(colour, n, toEye);
    if (isBack && hasInside) light *= 0.85;
  }
  if (outline > 0.0) {
    vec3 width = fwidth(share);
    vec3 near = smoothstep(vec3(0.0), width * 1.25, share);
    float side = 1.0 - min(near.x, min(near.y, near.z));
    float small = max(width.x, max(width.y, width.z));  // triangles of a few pixels have no sides
    light *= 1.0 - outline * side * (1.0 - smoothstep(0.12, 0.4, small));
  }
  light = withWave(light, way);
  pixel = vec4(display(isPlanar ? light : withFog(light, -eyePlace.z)), opacity);
}
`;

// Edges, four corners each, as wide as a stick or as a number of pixels.
export const kEdgeVertex = /* glsl */ `
${kCommon}
uniform usampler2D corners;
uniform sampler2D ownColours;
uniform sampler2D ends;      // used instead of points where hasEnds: two texels an edge
uniform bool hasEnds;
uniform vec3 colour;
uniform int colouring;
uniform float radius;        // scene units; 0 for pixels
uniform float pixels;        // width; the least of it where there is a radius

flat out vec3 colour0;
flat out vec3 colour1;
out vec3 eyePlace;
out vec3 scenePlace;
out vec2 across;             // -1..1 across, 0..1 along
out float way;

void main() {
  int edge = gl_VertexID >> 2;
  int corner = gl_VertexID & 3;
  vec3 place[2];
  float ways[2] = float[2](0.0, 0.0);
  colour0 = colour1 = colour;
  if (hasEnds) {
    place[0] = texelFetch(ends, texel(2 * edge), 0).xyz;
    place[1] = texelFetch(ends, texel(2 * edge + 1), 0).xyz;
  } else {
    uvec4 both = texelFetch(corners, texel(edge), 0);
    place[0] = placed(int(both.x));
    place[1] = placed(int(both.y));
    ways[0] = wayTo(int(both.x));
    ways[1] = wayTo(int(both.y));
    if (colouring == 1) {
      colour0 = colourOf(int(both.x));
      colour1 = colourOf(int(both.y));
    } else if (colouring == 2) {
      colour0 = colour1 = texelFetch(ownColours, texel(edge), 0).rgb;
    }
  }
  if (explosion > 0.0 && !explodesParts && !hasEnds) {
    vec3 middle = (place[0] + place[1]) / 2.0;
    place[0] += explosion * middle;
    place[1] += explosion * middle;
  }
  int end = corner >> 1;
  float side = (corner & 1) == 0 ? -1.0 : 1.0;
  vec4 eye[2] = vec4[2](view * vec4(place[0], 1.0), view * vec4(place[1], 1.0));
  vec4 clip[2] = vec4[2](projection * eye[0], projection * eye[1]);
  vec2 direction = (clip[1].xy / clip[1].w - clip[0].xy / clip[0].w) * viewport;
  direction = length(direction) > 1e-6 ? normalize(direction) : vec2(1.0, 0.0);
  float half_ = max(0.5 * pixels, 0.5 * radius * projection[1][1] * viewport.y / clip[end].w);
  vec2 shift = (side * vec2(-direction.y, direction.x) + (end == 0 ? -0.6 : 0.6) * direction) * half_;
  gl_Position = clip[end];
  gl_Position.xy += 2.0 * shift / viewport * clip[end].w;
  eyePlace = eye[end].xyz;
  scenePlace = place[end];
  across = vec2(side, float(end));
  way = ways[end];
}
`;

export const kEdgeFragment = /* glsl */ `
${kFragmentCommon}
uniform bool isPlanar;
flat in vec3 colour0;
flat in vec3 colour1;
in vec3 eyePlace;
in vec3 scenePlace;
in vec2 across;
in float way;

void main() {
  if (dot(clipPlane, vec4(scenePlace, 1.0)) > 0.0) discard;
  vec3 colour = across.y < 0.5 ? colour0 : colour1;
  float height = sqrt(max(0.0, 1.0 - across.x * across.x));
  vec3 light = isPlanar ? linear(colour) : linear(colour) * (0.45 + 0.55 * height);
  light = withWave(light, way);
  pixel = vec4(display(isPlanar ? light : withFog(light, -eyePlace.z)), opacity);
}
`;

// Balls and points, four corners each. A quad that hides its ball from the eye lies before it; what
// is seen of the ball itself is found for every pixel.
export const kBallVertex = /* glsl */ `
${kCommon}
uniform float alpha2;        // scene units squared
uniform float pixels;        // of a point's diameter; 0 for balls
uniform vec3 colour;
uniform int colouring;
uniform bool isPlanar;

flat out vec3 centre;        // eye
flat out float radius;
flat out float radius2;
flat out vec3 ballColour;
flat out vec3 sceneCentre;
flat out float way;
out vec3 eyePlace;
out vec2 unit;

void main() {
  int point = gl_VertexID >> 2;
  int corner = gl_VertexID & 3;
  vec4 data = texelFetch(points, texel(point), 0);
  vec3 place = placed(point);
  if (explosion > 0.0 && !explodesParts) place += explosion * place;
  unit = vec2((corner & 1) == 0 ? -1.0 : 1.0, (corner & 2) == 0 ? -1.0 : 1.0);
  vec4 eye = view * vec4(place, 1.0);
  centre = eye.xyz;
  sceneCentre = place;
  ballColour = colouring == 1 ? colourOf(point) : colour;
  way = wayTo(point);
  float depth = projection[2][3] == 0.0 ? 1.0 : -eye.z;
  radius2 = data.w + alpha2;
  radius = radius2 > 0.0 ? sqrt(radius2) : 0.0;
  if (pixels > 0.0) {
    radius = pixels / viewport.y * depth / projection[1][1];
    radius2 = radius * radius;
  }
  if (radius == 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  float reach = radius;
  eyePlace = eye.xyz;
  if (projection[2][3] != 0.0) {
    // A square across the line of sight, touching the ball's front, as large as its cone there.
    vec3 toEye = normalize(-eye.xyz);
    float away = length(eye.xyz);
    reach = away > 1.001 * radius ? radius * sqrt((away - radius) / (away + radius)) : 100.0 * radius;
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), toEye));
    vec3 up = cross(toEye, right);
    eyePlace += toEye * radius + reach * (unit.x * right + unit.y * up);
  } else {
    eyePlace += vec3(unit * reach, radius);
  }
  gl_Position = projection * vec4(eyePlace, 1.0);
}
`;

export const kBallFragment = /* glsl */ `
${kFragmentCommon}
uniform mat4 projection;
uniform mat4 view;
uniform float pixels;
uniform bool isPlanar;
uniform float planarDepth;   // power distances from 0 down to minus this become depths
flat in vec3 centre;
flat in float radius;
flat in float radius2;
flat in vec3 ballColour;
flat in vec3 sceneCentre;
flat in float way;
in vec3 eyePlace;
in vec2 unit;

void main() {
  if (isPlanar) {
    float far = dot(unit, unit);
    float radiusShare = sqrt(far);
    float cover = clamp((1.0 - radiusShare) / fwidth(radiusShare), 0.0, 1.0);
    if (cover == 0.0) discard;
    // The ball with the least power distance is seen: where it is, is its power cell.
    float power = radius2 * (far - 1.0);
    gl_FragDepth = pixels > 0.0 ? 0.0 : 0.9 * (1.0 + power / planarDepth) + 0.02;
    vec3 flat_ = linear(ballColour);
    if (pixels > 0.0 && far > 0.62) flat_ *= 0.6;
    pixel = vec4(display(withWave(flat_, way)), opacity * cover);
    return;
  }
  vec3 direction = isOrthographic ? vec3(0.0, 0.0, -1.0) : normalize(eyePlace);
  vec3 origin = isOrthographic ? vec3(eyePlace.xy, 0.0) : vec3(0.0);
  vec3 toCentre = centre - origin;
  float along = dot(toCentre, direction);
  float miss2 = dot(toCentre, toCentre) - along * along;
  float half2 = radius2 - miss2;
  if (half2 < 0.0) discard;
  float half_ = sqrt(half2);
  vec3 hit = origin + (along - half_) * direction;
  vec3 n = (hit - centre) / radius;
  // Above the clipping plane: go on to where the ray comes below it, still inside the ball.
  vec3 up = mat3(view) * clipPlane.xyz;
  float above = dot(up, hit - centre) + dot(clipPlane, vec4(sceneCentre, 1.0));
  bool isCut = above > 0.0;
  if (isCut) {
    float slope = dot(up, direction);
    if (slope >= 0.0) discard;
    float step_ = -above / slope;
    if (step_ > 2.0 * half_) discard;
    hit += step_ * direction;
  }
  vec4 clip = projection * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
  vec3 toEye = -direction;
  vec3 light = isCut ? 0.85 * linear(ballColour) : lit(ballColour, n, toEye);
  light = withWave(light, way);
  pixel = vec4(display(withFog(light, -hit.z)), opacity);
}
`;

// All edges of the triangulation as thin lines; corners are points.
export const kLineVertex = /* glsl */ `
${kCommon}
out vec3 eyePlace;
out vec3 scenePlace;
void main() {
  scenePlace = placed(gl_VertexID);
  eyePlace = (view * vec4(scenePlace, 1.0)).xyz;
  gl_Position = projection * vec4(eyePlace, 1.0);
}
`;

export const kLineFragment = /* glsl */ `
${kFragmentCommon}
uniform vec3 colour;
in vec3 eyePlace;
in vec3 scenePlace;
void main() {
  if (dot(clipPlane, vec4(scenePlace, 1.0)) > 0.0) discard;
  pixel = vec4(display(withFog(linear(colour), -eyePlace.z)), opacity);
}
`;
