// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import { defineConfig, type Plugin } from 'vite';

/** Puts script and style into the page, so that it opens from a disk without a server. */
function oneFile(): Plugin {
  return {
    name: 'one-file',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') throw new Error('one-file: the bundle has no index.html');
      let html = String(page.source);
      for (const [name, file] of Object.entries(bundle)) {
        if (file === page) continue;
        const tag = new RegExp(
          file.type === 'chunk'
            ? `<script[^>]*src="[^"]*${name}"[^>]*></script>`
            : `<link[^>]*href="[^"]*${name}"[^>]*>`,
        );
        if (!tag.test(html)) throw new Error(`one-file: the page does not use ${name}`);
        if (file.type === 'chunk') {
          // After the data, so at the end of the body.
          const code = file.code.replaceAll('</script', '<\\/script');
          html = html.replace(tag, '');
          html = html.replace('</body>', () => `<script type="module">${code}</script>\n</body>`);
        } else {
          html = html.replace(tag, () => `<style>${String(file.source)}</style>`);
        }
        delete bundle[name];
      }
      page.source = html;
    },
  };
}

export default defineConfig({
  plugins: [oneFile()],
  build: {
    target: 'es2022',
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    reportCompressedSize: false,
  },
});
