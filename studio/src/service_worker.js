// Keeps the whole studio in the browser, so that it opens without a network. Both words below are filled in by
// the build.
const FILES = __FILES__;
const CACHE = `snug-${__VERSION__}`;

self.addEventListener('install', (event) => {
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES)));
  self.skipWaiting();
});

self.addEventListener('activate', (event) => {
  const old = (names) => names.filter((name) => name.startsWith('snug-') && name !== CACHE);
  event.waitUntil(
    caches
      .keys()
      .then((names) => Promise.all(old(names).map((name) => caches.delete(name))))
      .then(() => self.clients.claim()),
  );
});

// The network first, so that a new version is seen at once; the kept files where there is none.
self.addEventListener('fetch', (event) => {
  const {request} = event;
  if (request.method !== 'GET' || new URL(request.url).origin !== self.location.origin) return;
  const kept = () => caches.match(request, {ignoreSearch: request.mode === 'navigate', ignoreVary: true, cacheName: CACHE});
  event.respondWith(
    fetch(request).catch(async (reason) => {
      const file = await kept();
      if (file) return file;
      throw reason;
    }),
  );
});
