/** The content of a file that has been put into its own address, as it is in the one file; of any other nothing, since that
 *  must be fetched. */
export function bytesIn(address: string): {wasmBinary?: Uint8Array<ArrayBuffer>} {
  const [kind = '', base64] = address.split(',', 2);
  if (!kind.startsWith('data:') || base64 === undefined) return {};
  return {wasmBinary: Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))};
}
