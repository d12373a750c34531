// The part of Google's Draco decoder that is used; its package has no types.
declare module 'draco3d/draco_decoder_nodejs.js' {
  interface Status {
    ok(): boolean;
  }
  interface Attribute {
    ptr: number;
    num_components(): number;
    data_type(): number;
  }
  interface Mesh {
    num_points(): number;
    num_faces(): number;
  }
  interface DecoderBuffer {
    Init(data: Int8Array, size: number): void;
  }
  interface Decoder {
    DecodeBufferToMesh(buffer: DecoderBuffer, mesh: Mesh): Status;
    GetAttributeByUniqueId(mesh: Mesh, id: number): Attribute | null;
    GetAttributeDataArrayForAllPoints(mesh: Mesh, attribute: Attribute, type: number, bytes: number, to: number): boolean;
    GetTrianglesUInt32Array(mesh: Mesh, bytes: number, to: number): boolean;
  }
  export interface DecoderModule {
    Decoder: new () => Decoder;
    DecoderBuffer: new () => DecoderBuffer;
    Mesh: new () => Mesh;
    DT_INT32: number;
    DT_FLOAT32: number;
    DT_FLOAT64: number;
    HEAPF32: Float32Array;
    _malloc(bytes: number): number;
    _free(place: number): void;
    destroy(object: unknown): void;
  }
  export default function createDecoder(options: {locateFile?: () => string; wasmBinary?: Uint8Array}): Promise<DecoderModule>;
}
