import {violations} from '../e2e/support/axe';
import {expect, ONE_FILE, PLAIN, test} from '../e2e/support/studio';
import {Walk} from '../e2e/support/walk';
import {MOST_CLICKS, MOST_DECISIONS, speak, WALKS} from '../e2e/support/walks';

// Every walk from the opened page to the pack, from a host and from one file on a disk, in both languages, on a table, a
// tablet and a phone.

const ADDRESSES = {'from a host': PLAIN, 'from a disk': ONE_FILE};
const DEVICES = {
  'on a table': {viewport: {width: 1280, height: 800}},
  'on a tablet': {viewport: {width: 820, height: 1180}, hasTouch: true},
  'on a phone': {viewport: {width: 390, height: 844}, hasTouch: true},
};

for (const [where, address] of Object.entries(ADDRESSES))
  for (const [on, device] of Object.entries(DEVICES))
    for (const code of ['en', 'ja'] as const)
      test.describe(`${where}, ${on}, ${code}`, () => {
        test.use({address, ...device});
        for (const [name, go] of Object.entries(WALKS))
          test(name, async ({studio: page}) => {
            const began = Date.now();
            const walk = new Walk(page);
            const t = await speak(page, code);
            const look = async () => expect(await violations(page)).toEqual([]);
            const files = await go({page, t, walk, look});
            expect(Object.keys(files)).toEqual(expect.arrayContaining(['project.snug.json', 'preview.svg', 'start-here.txt']));
            console.log(`${walk.clicks} clicks, ${walk.decisions} decisions, ${Math.round((Date.now() - began) / 1000)} s`);
            expect(walk.clicks).toBeLessThanOrEqual(MOST_CLICKS);
            expect(walk.decisions).toBeLessThanOrEqual(MOST_DECISIONS);
          });
      });
