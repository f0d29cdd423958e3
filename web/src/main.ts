import { mount } from 'svelte';
import 'uplot/dist/uPlot.min.css';
import './app.css';
import App from './app.svelte';
import { session } from './live/session.svelte';
import { words } from './words/index.svelte';

const target = document.getElementById('panel');
if (!target) throw new Error('index.html has no place for the panel');
void words.begin().then(() => mount(App, { target }));
void session.begin();
