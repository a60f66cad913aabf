// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0

/** The bytes of base64 text. Throws where it is none. */
export function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

export const floatsOf = (text: string): Float32Array => new Float32Array(bytesOf(text).buffer);
export const shortsOf = (text: string): Uint16Array => new Uint16Array(bytesOf(text).buffer);
export const longsOf = (text: string): Uint32Array => new Uint32Array(bytesOf(text).buffer);
