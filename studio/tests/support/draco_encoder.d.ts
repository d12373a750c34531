// The part of Google's Draco encoder that tests use; its package has no types.
declare module 'draco3d/draco_encoder_nodejs.js' {
  interface Mesh {
    readonly draco: 'mesh';
  }
  interface Bytes {
    GetValue(at: number): number;
  }
  interface MeshBuilder {
    AddFacesToMesh(mesh: Mesh, count: number, corners: Uint32Array): boolean;
    AddFloatAttributeToMesh(mesh: Mesh, kind: number, count: number, components: number, values: Float32Array): number;
  }
  interface Encoder {
    SetAttributeQuantization(kind: number, bits: number): void;
    EncodeMeshToDracoBuffer(mesh: Mesh, to: Bytes): number;
  }
  interface EncoderModule {
    Encoder: new () => Encoder;
    MeshBuilder: new () => MeshBuilder;
    Mesh: new () => Mesh;
    DracoInt8Array: new () => Bytes;
    POSITION: number;
  }
  export default function createEncoder(options: object): Promise<EncoderModule>;
}
