// How a body looks: paint under a studio sky, zebra stripes, or colours of a map.
import { DataTexture, DoubleSide, LinearFilter, RGBAFormat, ShaderMaterial, Vector3 } from 'three';

/** The looks, in the order of their numbers in the shader. */
export const looks = { paint: 0, zebra: 1, map: 2 };

// With BLENDED, bodies have a second set of attributes, and `blend` leads from the one to the other.
const vertexShader = `
  attribute float value, known;
  #ifdef BLENDED
    attribute vec3 position1, normal1;
    attribute float value1, known1;
    uniform float blend;
  #endif
  varying vec3 outward, place;
  varying float mapped, sure;
  void main() {
    vec3 p = position, n = normal;
    mapped = value;
    sure = known;
    #ifdef BLENDED
      p = mix(p, position1, blend);
      n = mix(n, normal1, blend);
      mapped = mix(value, value1, blend);
      sure = mix(known, known1, blend);
    #endif
    vec4 world = modelMatrix * vec4(p, 1.0);
    place = world.xyz;
    outward = mat3(modelMatrix) * n;
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

const fragmentShader = `
  varying vec3 outward, place;
  varying float mapped, sure;
  uniform vec3 tint;
  uniform float period, opacity;
  uniform int look;
  uniform sampler2D scale;
  vec3 sky(vec3 d) {
    float light = mix(0.40, 0.95, smoothstep(-0.05, 0.8, d.z));
    light = mix(0.78, light, smoothstep(-0.25, 0.05, d.z));
    light += 0.80 * smoothstep(0.30, 0.42, d.z) * (1.0 - smoothstep(0.50, 0.62, d.z));
    light += 0.90 * smoothstep(0.84, 0.94, d.z);
    return vec3(0.985, 0.995, 1.02) * light;
  }
  vec3 paint(vec3 n, vec3 d, float facing) {
    vec3 base = tint * (0.62 + 0.38 * n.z);
    float mirrored = 0.16 + 0.4 * pow(1.0 - facing, 4.0);
    return base + mirrored * sky(d);
  }
  float zebra(vec3 d) {
    float stripe = degrees(acos(clamp(d.z, -1.0, 1.0))) / period;
    float edge = max(fwidth(stripe), 1e-4);
    float wave = abs(fract(stripe) - 0.5) - 0.25;
    return clamp(0.5 + wave / edge, 0.0, 1.0);
  }
  void main() {
    vec3 n = normalize(outward), toEye = normalize(cameraPosition - place);
    float facing = dot(n, toEye);
    vec3 d = 2.0 * facing * n - toEye;
    float form = 0.72 + 0.28 * max(0.0, dot(n, normalize(toEye + vec3(0.0, 0.0, 0.8))));
    vec3 chosen = paint(n, d, max(facing, 0.0));
    if (look == 1) chosen = form * mix(vec3(0.96), vec3(0.12, 0.13, 0.16), zebra(d));
    vec3 color = sure > 0.5 ? texture2D(scale, vec2(0.5 + 0.5 * mapped, 0.5)).rgb : vec3(0.59, 0.60, 0.63);
    if (look == 2) chosen = form * color;
    gl_FragColor = vec4(facing < -0.12 ? vec3(0.20, 0.22, 0.25) : chosen, opacity);
  }`;

/**
 * A texture from RGB bytes, for values from -1 to 1.
 * @param {Uint8Array} rgb
 */
export function scaleTexture(rgb) {
  const rgba = new Uint8Array((rgb.length / 3) * 4).fill(255);
  for (let k = 0; k < rgb.length / 3; ++k) rgba.set(rgb.subarray(3 * k, 3 * k + 3), 4 * k);
  const texture = new DataTexture(rgba, rgb.length / 3, 1, RGBAFormat);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/**
 * @param {DataTexture} scale colours of the map
 * @param {{period: number, blended?: boolean}} options period of the zebra stripes in degrees
 */
export function bodyMaterial(scale, { period, blended = false }) {
  return new ShaderMaterial({
    vertexShader,
    fragmentShader,
    side: DoubleSide,
    defines: blended ? { BLENDED: '' } : {},
    uniforms: {
      scale: { value: scale },
      period: { value: period },
      look: { value: looks.paint },
      blend: { value: 1 },
      opacity: { value: 1 },
      tint: { value: new Vector3(0.46, 0.55, 0.66) },
    },
  });
}
